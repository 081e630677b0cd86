(** ** Expressions: sums of terms, and what they are in any ring *)

(** A fraction, times the square root of a product of radicands, times powers of variables (each with its number, from 0). *)
Record term := Term {
  numerator : BinInt.Z;
  denominator : BinInt.Z;
  root : list bool;
  powers : list (nat * nat)
}.

Fixpoint under_root (radicands : list BinInt.Z) (mask : list bool) : BinInt.Z :=
  match mask, radicands with
  | [], _ => 1%Z
  | true :: _, [] => 0%Z
  | false :: mask', [] => under_root [] mask'
  | true :: mask', d :: radicands' => (d * under_root radicands' mask')%Z
  | false :: mask', _ :: radicands' => under_root radicands' mask'
  end.

Definition product (factors : list R) : R :=
  match factors with [] => 1 | first :: rest => fold_left Rmult rest first end.

(** A term without its sign and a sum of terms, spelled as people spell them: 8 * sqrt 3 / 3 * w * z, no factor 1, no power 1. *)
Definition number_spelled (radicands : list BinInt.Z) (t : term) : list R :=
  let root_factor := if existsb (fun b => b) (root t) then [sqrt (IZR (under_root radicands (root t)))] else [] in
  let above := match Z.abs (numerator t) with 1%Z => root_factor | n => IZR n :: root_factor end in
  match denominator t with
  | 1%Z => above
  | d => [product above / IZR d]
  end.

Definition power_spelled (values : list R) (power : nat * nat) : R :=
  match snd power with
  | 1%nat => nth (fst power) values 0
  | exponent => nth (fst power) values 0 ^ exponent
  end.

Definition size (radicands : list BinInt.Z) (values : list R) (t : term) : R :=
  product (number_spelled radicands t ++ map (power_spelled values) (powers t)).

Definition is_negative (t : term) : bool := (numerator t <? 0)%Z.

Definition spelled (radicands : list BinInt.Z) (values : list R) (terms : list term) : R :=
  match terms with
  | [] => 0
  | first :: rest =>
      fold_left (fun sum t => if is_negative t then sum - size radicands values t else sum + size radicands values t) rest
        (if is_negative first then - size radicands values first else size radicands values first)
  end.

(** The same without regard for spelling. *)
Fixpoint root_product (roots : list R) (mask : list bool) : R :=
  match mask, roots with
  | [], _ => 1
  | true :: _, [] => 0
  | false :: mask', [] => root_product [] mask'
  | true :: mask', r :: roots' => r * root_product roots' mask'
  | false :: mask', _ :: roots' => root_product roots' mask'
  end.

Fixpoint power_product (values : list R) (powers : list (nat * nat)) : R :=
  match powers with
  | [] => 1
  | (k, e) :: rest => nth k values 0 ^ e * power_product values rest
  end.

Definition term_value (roots values : list R) (t : term) : R :=
  IZR (numerator t) / IZR (denominator t) * root_product roots (root t) * power_product values (powers t).

Fixpoint sum_value (roots values : list R) (terms : list term) : R :=
  match terms with [] => 0 | t :: rest => term_value roots values t + sum_value roots values rest end.

Definition square_roots (radicands : list BinInt.Z) : list R := map (fun d => sqrt (IZR d)) radicands.

Definition nonnegative (radicands : list BinInt.Z) : bool := forallb (fun d => (0 <=? d)%Z) radicands.

Lemma square_roots_square : forall radicands,
  nonnegative radicands = true -> squares radicands (square_roots radicands).
Proof.
  induction radicands as [| d rest IH]; intros H; simpl; constructor.
  - apply sqrt_sqrt, IZR_le, Z.leb_le; apply andb_prop in H; tauto.
  - apply IH; simpl in H; apply andb_prop in H; tauto.
Qed.

Lemma root_of_product : forall mask radicands, nonnegative radicands = true ->
  (0 <= under_root radicands mask)%Z /\ sqrt (IZR (under_root radicands mask)) = root_product (square_roots radicands) mask.
Proof.
  induction mask as [| b mask IH]; intros radicands H.
  - split; [destruct radicands; simpl; lia |]; destruct radicands; simpl; apply sqrt_1.
  - destruct radicands as [| d rest].
    + destruct b; simpl; [split; [lia | apply sqrt_0] | apply (IH []); reflexivity].
    + unfold nonnegative in H; simpl in H; apply andb_prop in H as [Hd H]; apply Z.leb_le in Hd.
      destruct (IH rest H) as [IHn IHr]; destruct b; simpl; [| split; assumption].
      split; [apply Z.mul_nonneg_nonneg; assumption |].
      rewrite mult_IZR, sqrt_mult_alt, IHr; [reflexivity | apply IZR_le; assumption].
Qed.

Lemma product_app : forall l m, product (l ++ m) = product l * product m.
Proof.
  assert (shift : forall l a, fold_left Rmult l a = a * product l).
  { intros l; induction l as [| b l IH] using rev_ind; intros a; simpl; [ring |].
    rewrite fold_left_app; cbn [fold_left]; rewrite IH; destruct l as [| c l]; simpl; [ring |].
    rewrite fold_left_app; cbn [fold_left]; ring. }
  intros [| a l] m; simpl; [ring |].
  rewrite fold_left_app, !shift; ring.
Qed.

Section Values.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.
Let roots := square_roots radicands.
Variable values : list R.

Lemma powers_value : forall l, product (map (power_spelled values) l) = power_product values l.
Proof.
  induction l as [| [k e] rest IH]; [reflexivity |].
  change (map ?f (?a :: ?l)) with ([f a] ++ map f l); rewrite product_app, IH; unfold power_spelled.
  destruct e as [| [| e]]; simpl; ring.
Qed.

Lemma no_root : forall mask l, existsb (fun b => b) mask = false -> root_product l mask = 1.
Proof.
  induction mask as [| [|] mask IH]; intros [| r l] H; try discriminate; try reflexivity; apply IH; assumption.
Qed.

Lemma number_value : forall t,
  product (number_spelled radicands t) = IZR (Z.abs (numerator t)) / IZR (denominator t) * root_product roots (root t).
Proof.
  intros t; unfold number_spelled.
  set (root_factor := if existsb (fun b => b) (root t) then _ else _).
  assert (of_root : product root_factor = root_product roots (root t)).
  { unfold root_factor; destruct (existsb (fun b => b) (root t)) eqn:E.
    - apply root_of_product; assumption.
    - symmetry; apply no_root; assumption. }
  set (above := match Z.abs (numerator t) with 1%Z => root_factor | n => IZR n :: root_factor end).
  assert (of_above : product above = IZR (Z.abs (numerator t)) * root_product roots (root t)).
  { rewrite <- of_root; unfold above; destruct (Z.abs (numerator t)) as [| [n | n |] | n];
      try (change (IZR ?z :: ?l) with ([IZR z] ++ l); rewrite product_app; reflexivity); simpl; ring. }
  unfold Rdiv; rewrite Rmult_assoc, (Rmult_comm (/ _)), <- Rmult_assoc, <- of_above.
  destruct (denominator t) as [| [d | d |] | d]; try reflexivity; simpl; field.
Qed.

Lemma size_value : forall t, term_value roots values t = if is_negative t then - size radicands values t else size radicands values t.
Proof.
  intros t; unfold size; rewrite product_app, powers_value, number_value; unfold term_value, is_negative.
  destruct (Z.ltb_spec (numerator t) 0) as [H | H].
  - rewrite Z.abs_neq, opp_IZR by lia; unfold Rdiv; ring.
  - rewrite Z.abs_eq by lia; ring.
Qed.

Lemma spelled_value : forall terms, spelled radicands values terms = sum_value roots values terms.
Proof.
  assert (shift : forall terms start,
    fold_left (fun sum t => if is_negative t then sum - size radicands values t else sum + size radicands values t) terms start
    = start + sum_value roots values terms).
  { induction terms as [| t rest IH]; intros start; simpl; [ring |].
    rewrite IH, size_value; destruct (is_negative t); ring. }
  intros [| t rest]; simpl; [reflexivity |].
  rewrite shift, size_value; reflexivity.
Qed.

End Values.

(** In a ring: its operations, and a map to the reals that respects them. Everything is multiplied by a common denominator. *)

Fixpoint with_root (mask : list bool) (n : BinInt.Z) : number :=
  match mask with
  | [] => Int n
  | true :: mask' => Ext (Int 0) (with_root mask' n)
  | false :: mask' => Ext (with_root mask' n) (Int 0)
  end.

Lemma value_with_root : forall mask roots n, value roots (with_root mask n) = IZR n * root_product roots mask.
Proof.
  induction mask as [| [|] mask IH]; intros [| r roots] n; simpl; rewrite ?IH; ring.
Qed.

Definition divides (common : BinInt.Z) (terms : list term) : bool :=
  forallb (fun t => negb (denominator t =? 0)%Z && (common / denominator t * denominator t =? common)%Z) terms.

Section Ring.

Variable A : Type.
Variables plus_A times_A : A -> A -> A.
Variable zero_A : A.
Variable number_A : number -> A.

Fixpoint power_A (a : A) (exponent : nat) : A :=
  match exponent with
  | O => number_A (Int 1)
  | 1%nat => a
  | S e => times_A a (power_A a e)
  end.

Definition term_A (common : BinInt.Z) (variables : list A) (t : term) : A :=
  fold_left (fun product power => times_A product (power_A (nth (fst power) variables zero_A) (snd power))) (powers t)
    (number_A (with_root (root t) (numerator t * (common / denominator t)))).

Fixpoint sum_A (common : BinInt.Z) (variables : list A) (terms : list term) : A :=
  match terms with
  | [] => zero_A
  | t :: rest => plus_A (term_A common variables t) (sum_A common variables rest)
  end.

Variable roots : list R.
Variable real : A -> R.
Hypothesis real_plus : forall a b, real (plus_A a b) = real a + real b.
Hypothesis real_times : forall a b, real (times_A a b) = real a * real b.
Hypothesis real_zero : real zero_A = 0.
Hypothesis real_number : forall n, real (number_A n) = value roots n.

Lemma real_power : forall a exponent, real (power_A a exponent) = real a ^ exponent.
Proof.
  intros a exponent; induction exponent as [| [| e] IH].
  - simpl; rewrite real_number; destruct roots; reflexivity.
  - simpl; ring.
  - change (power_A a (S (S e))) with (times_A a (power_A a (S e))); rewrite real_times, IH; reflexivity.
Qed.

Lemma real_sum : forall common variables terms, divides common terms = true ->
  real (sum_A common variables terms) = IZR common * sum_value roots (map real variables) terms.
Proof.
  intros common variables.
  assert (products : forall l a,
    real (fold_left (fun product power => times_A product (power_A (nth (fst power) variables zero_A) (snd power))) l a)
    = real a * power_product (map real variables) l).
  { induction l as [| [k e] rest IH]; intros a; simpl; [ring |].
    rewrite IH, real_times, real_power; cbn [fst snd].
    rewrite <- real_zero, map_nth; ring. }
  induction terms as [| t rest IH]; intros H; simpl.
  - rewrite real_zero; ring.
  - simpl in H; apply andb_prop in H as [H Hrest]; apply andb_prop in H as [Hd Hc].
    rewrite real_plus, (IH Hrest); unfold term_A; rewrite products, real_number, value_with_root, mult_IZR.
    apply negb_true_iff, Z.eqb_neq in Hd; apply Z.eqb_eq in Hc.
    assert (split : IZR common = IZR (common / denominator t) * IZR (denominator t)) by (rewrite <- mult_IZR, Hc; reflexivity).
    unfold term_value; rewrite split; field; apply not_0_IZR; assumption.
Qed.

End Ring.
