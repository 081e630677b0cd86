(** ** Polynomials in one more variable, as lists of coefficients *)

Fixpoint horner (coefficients : list R) (x : R) : R :=
  match coefficients with [] => 0 | a :: rest => a + x * horner rest x end.

Section Lists.

Variable A : Type.
Variables plus_A times_A : A -> A -> A.
Variable zero_A : A.

Fixpoint plus_list (p q : list A) : list A :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | a :: p', b :: q' => plus_A a b :: plus_list p' q'
  end.

Fixpoint times_list (p q : list A) : list A :=
  match p with
  | [] => []
  | a :: p' => plus_list (map (times_A a) q) (zero_A :: times_list p' q)
  end.

Variable real : A -> R.
Hypothesis real_plus : forall a b, real (plus_A a b) = real a + real b.
Hypothesis real_times : forall a b, real (times_A a b) = real a * real b.
Hypothesis real_zero : real zero_A = 0.

Lemma horner_plus : forall x p q,
  horner (map real (plus_list p q)) x = horner (map real p) x + horner (map real q) x.
Proof.
  intros x; induction p as [| a p IH]; intros [| b q]; simpl; try ring.
  rewrite IH, real_plus; ring.
Qed.

Lemma horner_times : forall x p q,
  horner (map real (times_list p q)) x = horner (map real p) x * horner (map real q) x.
Proof.
  intros x p q; induction p as [| a p IH]; [simpl; ring |].
  cbn [times_list]; rewrite horner_plus; cbn [map horner]; rewrite IH, real_zero.
  assert (single : horner (map real (map (times_A a) q)) x = real a * horner (map real q) x).
  { clear IH; induction q as [| b q IH]; simpl; [ring | rewrite IH, real_times; ring]. }
  rewrite single; ring.
Qed.

End Lists.

(** A polynomial is zero, or it does not vanish at any small positive number. *)

Lemma horner_bound : forall l, exists bound, 0 <= bound /\ forall x, 0 <= x <= 1 -> Rabs (horner l x) <= bound.
Proof.
  induction l as [| a l [bound [nonnegative IH]]].
  - exists 0; split; [lra |]; intros; simpl; rewrite Rabs_R0; lra.
  - exists (Rabs a + bound); split; [pose proof (Rabs_pos a); lra |].
    intros x Hx; simpl.
    pose proof (Rabs_triang a (x * horner l x)); specialize (IH x Hx).
    rewrite Rabs_mult, (Rabs_pos_eq x) in * by lra.
    assert (x * Rabs (horner l x) <= 1 * bound).
    { apply Rmult_le_compat; try lra; apply Rabs_pos. }
    lra.
Qed.

Lemma zero_or_not : forall l, Forall (fun a => a = 0) l \/
  exists bound, 0 < bound /\ forall x, 0 < x < bound -> horner l x <> 0.
Proof.
  induction l as [| a l IH]; [left; constructor |].
  destruct (Req_dec a 0) as [Ha | Ha].
  - destruct IH as [IH | [bound [positive IH]]]; [left; constructor; assumption | right].
    exists bound; split; [assumption |]; intros x Hx; simpl; rewrite Ha, Rplus_0_l.
    apply Rmult_integral_contrapositive_currified; [lra | apply IH; assumption].
  - right; destruct (horner_bound l) as [bound [nonnegative H]].
    assert (positive : 0 < Rabs a) by (apply Rabs_pos_lt; assumption).
    exists (Rmin 1 (Rabs a / (bound + 1))); split.
    { apply Rmin_glb_lt; [lra |]; apply Rdiv_lt_0_compat; lra. }
    intros x [Hx small] E; simpl in E.
    pose proof (Rmin_l 1 (Rabs a / (bound + 1))); pose proof (Rmin_r 1 (Rabs a / (bound + 1))).
    assert (range : 0 <= x <= 1) by lra; specialize (H x range).
    assert (equal : Rabs a = x * Rabs (horner l x)).
    { replace a with (- (x * horner l x)) by lra.
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq x) by lra; reflexivity. }
    assert (x * (bound + 1) < Rabs a).
    { replace (Rabs a) with (Rabs a / (bound + 1) * (bound + 1)) by (field; lra).
      apply Rmult_lt_compat_r; lra. }
    assert (x * Rabs (horner l x) <= x * bound) by (apply Rmult_le_compat_l; lra).
    lra.
Qed.

(** The same in two variables: rows of coefficients, the polynomial in the second variable within each. *)
Definition horner2 (grid : list (list R)) (t s : R) : R := horner (map (fun row => horner row s) grid) t.

Definition all_zero (grid : list (list R)) : Prop := Forall (Forall (fun a => a = 0)) grid.

Lemma zero_or_not2 : forall grid, all_zero grid \/
  exists bound, 0 < bound /\ forall s, 0 < s < bound ->
    exists bound', 0 < bound' /\ forall t, 0 < t < bound' -> horner2 grid t s <> 0.
Proof.
  induction grid as [| row grid IH]; [left; constructor |].
  destruct (zero_or_not row) as [Hrow | [bound [positive Hrow]]].
  - assert (vanishes : forall s, horner row s = 0).
    { intros s; clear IH; induction Hrow as [| a row Ha _ IH]; simpl; [reflexivity | rewrite Ha, IH; ring]. }
    destruct IH as [IH | [bound [positive IH]]]; [left; constructor; assumption | right].
    exists bound; split; [assumption |]; intros s Hs.
    destruct (IH s Hs) as [bound' [positive' IH']]; exists bound'; split; [assumption |].
    intros t Ht; unfold horner2; cbn [map horner]; rewrite vanishes, Rplus_0_l.
    apply Rmult_integral_contrapositive_currified; [lra | apply IH'; assumption].
  - right; exists bound; split; [assumption |]; intros s Hs.
    destruct (zero_or_not (map (fun row => horner row s) (row :: grid))) as [H | H]; [| exact H].
    exfalso; apply (Hrow s Hs); inversion H; assumption.
Qed.

(** Two polynomials that are not zero have a common place where neither vanishes. *)
Lemma common_place : forall f w, ~ all_zero f -> ~ all_zero w ->
  exists t s, 0 < t /\ 0 < s /\ horner2 f t s <> 0 /\ horner2 w t s <> 0.
Proof.
  intros f w Hf Hw.
  destruct (zero_or_not2 f) as [H | [b [Hb F]]]; [contradiction |].
  destruct (zero_or_not2 w) as [H | [c [Hc G]]]; [contradiction |].
  pose proof (Rmin_glb_lt b c 0 Hb Hc); pose proof (Rmin_l b c); pose proof (Rmin_r b c).
  set (s := Rmin b c / 2).
  destruct (F s) as [b' [Hb' F']]; [unfold s; lra |].
  destruct (G s) as [c' [Hc' G']]; [unfold s; lra |].
  pose proof (Rmin_glb_lt b' c' 0 Hb' Hc'); pose proof (Rmin_l b' c'); pose proof (Rmin_r b' c').
  exists (Rmin b' c' / 2), s; repeat split; [lra | unfold s; lra | apply F'; lra | apply G'; lra].
Qed.

(** ** Bezier polynomials at u = x/(1+x) *)

Fixpoint weighted {A : Type} (multiply : BinInt.Z -> A -> A) (n i : nat) (l : list A) : list A :=
  match l with
  | [] => []
  | a :: rest => multiply (binomial n i) a :: weighted multiply n (S i) rest
  end.

Definition times_int (k : BinInt.Z) (x : R) : R := IZR k * x.

Lemma map_weighted : forall (A : Type) multiply (real : A -> R) n,
  (forall k a, real (multiply k a) = IZR k * real a) ->
  forall l i, map real (weighted multiply n i l) = weighted times_int n i (map real l).
Proof.
  intros A multiply real n H; induction l as [| a l IH]; intros i; simpl; [reflexivity |].
  rewrite H, IH; reflexivity.
Qed.

Lemma combined_horner : forall n x, 0 <= x -> forall a i, (i + length a = S n)%nat ->
  (1 + x) ^ n * combined n i a (x / (1 + x)) = x ^ i * horner (weighted times_int n i a) x.
Proof.
  intros n x Hx; induction a as [| first rest IH]; intros i Hi; simpl in *; [ring |].
  rewrite Rmult_plus_distr_l, IH by lia; simpl; unfold times_int, bernstein.
  assert (power : (1 + x) ^ n * ((x / (1 + x)) ^ i * (1 - x / (1 + x)) ^ (n - i)) = x ^ i).
  { replace (1 - x / (1 + x)) with (/ (1 + x)) by (field; lra).
    replace n with (i + (n - i))%nat at 1 by lia.
    unfold Rdiv; rewrite pow_add, Rpow_mult_distr.
    replace ((1 + x) ^ i * (1 + x) ^ (n - i) * (x ^ i * (/ (1 + x)) ^ i * (/ (1 + x)) ^ (n - i)))
      with (x ^ i * (((1 + x) ^ i * (/ (1 + x)) ^ i) * ((1 + x) ^ (n - i) * (/ (1 + x)) ^ (n - i)))) by ring.
    rewrite <- !Rpow_mult_distr, !Rinv_r, !pow1 by lra; ring. }
  replace ((1 + x) ^ n * (IZR (binomial n i) * (x / (1 + x)) ^ i * (1 - x / (1 + x)) ^ (n - i) * first))
    with (IZR (binomial n i) * first * ((1 + x) ^ n * ((x / (1 + x)) ^ i * (1 - x / (1 + x)) ^ (n - i)))) by ring.
  rewrite power; ring.
Qed.

Lemma bezier_horner : forall n a x, 0 <= x -> length a = S n ->
  (1 + x) ^ n * bezier a (x / (1 + x)) = horner (weighted times_int n 0 a) x.
Proof.
  intros n a x Hx Ha; unfold bezier; rewrite Ha; replace (S n - 1)%nat with n by lia.
  rewrite combined_horner by (simpl; assumption); ring.
Qed.

Lemma bezier_scale : forall c t a, bezier (map (Rmult c) a) t = c * bezier a t.
Proof.
  intros c t a; unfold bezier; rewrite map_length.
  assert (linear : forall n i, combined n i (map (Rmult c) a) t = c * combined n i a t).
  { intros n; induction a as [| first rest IH]; intros i; simpl; [ring | rewrite IH; ring]. }
  apply linear.
Qed.
