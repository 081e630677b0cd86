(** ** The coefficients of the surface condition *)

Lemma nth_zero : forall (A : Type) (real : A -> R) zero l k, real zero = 0 ->
  Forall (fun a => real a = 0) l -> real (nth k l zero) = 0.
Proof.
  intros A real zero l k Hzero H; rewrite Forall_forall in H.
  destruct (nth_in_or_default k l zero) as [I | E]; [apply H, I | rewrite E; exact Hzero].
Qed.

Section Patch.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.
Let roots := square_roots radicands.
Let are_roots : squares radicands roots := square_roots_square radicands radicands_nonnegative.

(** A net: rows of points of four expressions. *)
Definition net_terms := list (list (list (list term))).

Definition entry (k : nat) (p : list (list term)) : list term := nth k p [].

Definition point_of (values : list R) (p : list (list term)) : point :=
  Point (spelled radicands values (entry 0 p)) (spelled radicands values (entry 1 p))
        (spelled radicands values (entry 2 p)) (spelled radicands values (entry 3 p)).

Definition net_of (values : list R) (net : net_terms) : list (list point) := map (map (point_of values)) net.

Variables (m n : nat) (count : nat) (common : BinInt.Z) (net : net_terms).
Variables (degree : nat) (common_surface : BinInt.Z) (surface_terms : list term).

Definition regular : bool :=
  (length net =? S m)%nat
  && forallb (fun row => (length row =? S n)%nat) net
  && forallb (forallb (forallb (divides common))) net
  && negb (common =? 0)%Z.

Definition total (t : term) : nat := fold_right (fun power sum => (snd power + sum)%nat) 0%nat (powers t).

Definition homogeneous : bool :=
  divides common_surface surface_terms && negb (common_surface =? 0)%Z && forallb (fun t => (total t =? degree)%nat) surface_terms.

Definition multiply_row (k : BinInt.Z) : list polynomial -> list polynomial := map (multiply_poly radicands k).

(** Row r, place s: the coefficient of t^r s^s of a coordinate, where u = t/(1+t) and v = s/(1+s). *)
Definition coordinate_grid (k : nat) : list (list polynomial) :=
  weighted multiply_row m 0
    (map (fun row => weighted (multiply_poly radicands) n 0
                       (map (fun p => polynomial_of radicands common (variables count) (entry k p)) row)) net).

Definition condition : list (list polynomial) :=
  sum_A (list (list polynomial)) plus_grid (times_grid radicands) [] (fun x => [[constant x]])
    common_surface [coordinate_grid 0; coordinate_grid 1; coordinate_grid 2; coordinate_grid 3] surface_terms.

Variable values : list R.
Hypothesis values_count : length values = count.
Let at_ := at_values roots values.

Definition row_at (s : R) (row : list polynomial) : R := horner (map at_ row) s.
Definition grid_at (t s : R) (grid : list (list polynomial)) : R := horner (map (row_at s) grid) t.

Lemma grid_at_horner2 : forall t s grid, grid_at t s grid = horner2 (map (map at_) grid) t s.
Proof. intros; unfold grid_at, horner2; rewrite map_map; reflexivity. Qed.

Lemma row_plus : forall s p q, row_at s (plus_row p q) = row_at s p + row_at s q.
Proof. intros; apply horner_plus; intros; apply (at_plus radicands roots are_roots). Qed.

Lemma row_times : forall s p q, row_at s (times_row radicands p q) = row_at s p * row_at s q.
Proof.
  intros; apply horner_times; intros.
  - apply (at_plus radicands roots are_roots).
  - apply (at_times radicands roots are_roots).
  - exact (at_int roots values 0).
Qed.

Lemma grid_plus : forall t s p q, grid_at t s (plus_grid p q) = grid_at t s p + grid_at t s q.
Proof. intros; apply horner_plus; intros; apply row_plus. Qed.

Lemma grid_times : forall t s p q, grid_at t s (times_grid radicands p q) = grid_at t s p * grid_at t s q.
Proof. intros; apply horner_times; intros; [apply row_plus | apply row_times | reflexivity]. Qed.

Lemma multiply_poly_at : forall k p, at_ (multiply_poly radicands k p) = IZR k * at_ p.
Proof.
  intros; unfold at_, multiply_poly; rewrite (at_times radicands roots are_roots), (at_int roots); reflexivity.
Qed.

Lemma multiply_row_at : forall s k row, row_at s (multiply_row k row) = IZR k * row_at s row.
Proof.
  intros; unfold row_at, multiply_row; induction row as [| p row IH]; simpl; [ring |].
  rewrite IH, multiply_poly_at; ring.
Qed.

(** The coordinate of the real patch. *)
Definition coordinate_at (k : nat) (u v : R) : R :=
  bezier (map (fun row => bezier (map (fun p => spelled radicands values (entry k p)) row) v) net) u.

Hypothesis net_regular : regular = true.

Lemma entries_divide : forall k p, forallb (divides common) p = true -> divides common (entry k p) = true.
Proof.
  intros k p H; unfold entry; destruct (nth_in_or_default k p []) as [I | E].
  - rewrite forallb_forall in H; apply H, I.
  - rewrite E; reflexivity.
Qed.

Lemma row_value : forall k s row, 0 <= s -> length row = S n -> forallb (forallb (divides common)) row = true ->
  row_at s (weighted (multiply_poly radicands) n 0 (map (fun p => polynomial_of radicands common (variables count) (entry k p)) row))
  = (1 + s) ^ n * IZR common * bezier (map (fun p => spelled radicands values (entry k p)) row) (s / (1 + s)).
Proof.
  intros k s row Hs Hlength Hdivides; unfold row_at; rewrite map_weighted by exact multiply_poly_at.
  rewrite map_map, <- bezier_horner by (rewrite ?map_length; assumption).
  rewrite (map_ext_in _ (fun p => IZR common * spelled radicands values (entry k p))).
  - rewrite <- (map_map (fun p => spelled radicands values (entry k p)) (Rmult (IZR common))), bezier_scale; ring.
  - intros p I; rewrite forallb_forall in Hdivides; unfold at_.
    rewrite <- values_count; apply polynomial_of_value; [assumption |]; apply entries_divide, Hdivides, I.
Qed.

Lemma coordinate_value : forall k t s, 0 <= t -> 0 <= s ->
  grid_at t s (coordinate_grid k)
  = (1 + t) ^ m * (1 + s) ^ n * IZR common * coordinate_at k (t / (1 + t)) (s / (1 + s)).
Proof.
  intros k t s Ht Hs; unfold regular in net_regular.
  apply andb_prop in net_regular as [R1 _]; apply andb_prop in R1 as [R1 Hdivides]; apply andb_prop in R1 as [Hrows Hlengths].
  apply Nat.eqb_eq in Hrows; rewrite forallb_forall in Hdivides, Hlengths.
  unfold grid_at, coordinate_grid; rewrite (map_weighted _ _ _ _ (multiply_row_at s)), map_map.
  rewrite <- bezier_horner by (rewrite ?map_length; assumption).
  rewrite (map_ext_in _ (fun row => (1 + s) ^ n * IZR common * bezier (map (fun p => spelled radicands values (entry k p)) row) (s / (1 + s)))).
  - rewrite <- (map_map (fun row => bezier (map (fun p => spelled radicands values (entry k p)) row) (s / (1 + s))) (Rmult ((1 + s) ^ n * IZR common))).
    rewrite bezier_scale; unfold coordinate_at; ring.
  - intros row I; apply row_value; [assumption | apply Nat.eqb_eq, Hlengths, I | apply Hdivides, I].
Qed.

Lemma scaled_value : forall factor coordinates terms,
  forallb (fun t => (total t =? degree)%nat) terms = true ->
  sum_value roots (map (Rmult factor) coordinates) terms = factor ^ degree * sum_value roots coordinates terms.
Proof.
  intros factor coordinates.
  assert (products : forall l, power_product (map (Rmult factor) coordinates) l
    = factor ^ fold_right (fun power sum => (snd power + sum)%nat) 0%nat l * power_product coordinates l).
  { induction l as [| [k e] rest IH]; simpl; [ring |].
    rewrite IH, pow_add; replace (nth k (map (Rmult factor) coordinates) 0) with (factor * nth k coordinates 0).
    - rewrite Rpow_mult_distr; ring.
    - replace 0 with (factor * 0) at 2 by ring; symmetry; apply map_nth. }
  induction terms as [| t rest IH]; intros H; simpl; [ring |].
  simpl in H; apply andb_prop in H as [Ht H]; apply Nat.eqb_eq in Ht.
  rewrite (IH H); unfold term_value; rewrite products; fold (total t); rewrite Ht; ring.
Qed.

Hypothesis surface_homogeneous : homogeneous = true.

Definition surface_at (coordinates : list R) : R := sum_value roots coordinates surface_terms.

Definition coordinates_at (u v : R) : list R := map (fun k => coordinate_at k u v) [0; 1; 2; 3]%nat.

Lemma condition_value : forall t s, 0 <= t -> 0 <= s ->
  grid_at t s condition
  = IZR common_surface * (((1 + t) ^ m * (1 + s) ^ n * IZR common) ^ degree * surface_at (coordinates_at (t / (1 + t)) (s / (1 + s)))).
Proof.
  intros t s Ht Hs; unfold homogeneous in surface_homogeneous.
  apply andb_prop in surface_homogeneous as [H Htotal]; apply andb_prop in H as [Hdivides _].
  unfold condition; rewrite (real_sum _ _ _ _ _ roots (grid_at t s)); try assumption.
  - unfold surface_at; rewrite <- scaled_value by assumption.
    cbn [map coordinates_at]; rewrite !coordinate_value by assumption; reflexivity.
  - intros; apply grid_plus.
  - intros; apply grid_times.
  - reflexivity.
  - intros x; unfold grid_at, row_at; cbn [map horner]; unfold at_, constant; cbn [at_values Pphi]; unfold at_values; simpl; ring.
Qed.

(** *** What a certificate refutes *)

(** Assumptions d <> 0, each with the number of the variable that stands for 1/d. *)
Variable common_assumptions : BinInt.Z.
Variable assumptions : list (list term * nat).
Variable certificate : list derivation.

Definition assumption_polynomial (a : list term * nat) : polynomial :=
  minus_poly (times_poly radicands (polynomial_of radicands common_assumptions (variables count) (fst a)) (variable (snd a)))
    (constant (Int common_assumptions)).

Definition given_by (grid : list (list polynomial)) (p : premise) : polynomial :=
  match p with
  | c r s => nth s (nth r grid []) (constant (Int 0))
  | nonzero k => nth (k - 1) (map assumption_polynomial assumptions) (constant (Int 0))
  | _ => constant (Int 0)
  end.

Definition refuted : bool :=
  regular && homogeneous && forallb (fun a => divides common_assumptions (fst a)) assumptions
  && (let grid := condition in replay radicands (given_by grid) count [] certificate).

Hypothesis certificate_refutes : replay radicands (given_by condition) count [] certificate = true.
Hypothesis assumptions_divide : forallb (fun a => divides common_assumptions (fst a)) assumptions = true.
Hypothesis inverses : Forall (fun a => spelled radicands values (fst a) * nth (snd a) values 0 = 1) assumptions.

Lemma assumptions_vanish : Forall (fun q => at_ q = 0) (map assumption_polynomial assumptions).
Proof.
  apply Forall_map; rewrite Forall_forall in *; rewrite forallb_forall in assumptions_divide.
  intros [d j] I; specialize (inverses _ I); specialize (assumptions_divide _ I); cbn [fst snd] in *.
  unfold at_, assumption_polynomial; cbn [fst snd].
  rewrite (at_minus radicands roots are_roots), (at_times radicands roots are_roots), (at_int roots), at_variable.
  rewrite <- values_count.
  pose proof (polynomial_of_value radicands radicands_nonnegative values common_assumptions d assumptions_divide) as P.
  fold roots in P; rewrite P, Rmult_assoc, inverses; ring.
Qed.

Lemma condition_not_zero : ~ all_zero (map (map at_) condition).
Proof.
  intros Z; apply (replay_refutes radicands radicands_nonnegative values (given_by condition)) with (2 := Forall_nil _) (3 := certificate_refutes).
  intros p; destruct p as [r s | k | k | k]; cbn [given_by]; try exact (at_int roots values 0).
  - assert (row : Forall (fun q => at_ q = 0) (nth r condition [])).
    { destruct (nth_in_or_default r condition []) as [I | E]; [| rewrite E; constructor].
      apply (in_map (map at_)) in I; unfold all_zero in Z; rewrite Forall_forall in Z; apply Z in I.
      apply Forall_map in I; exact I. }
    apply nth_zero; [exact (at_int roots values 0) | exact row].
  - apply nth_zero; [exact (at_int roots values 0) | exact assumptions_vanish].
Qed.

Lemma misses : ~ all_zero (map (map at_) (coordinate_grid 3)) ->
  exists u v, 0 <= u <= 1 /\ 0 <= v <= 1 /\ coordinate_at 3 u v <> 0 /\ surface_at (coordinates_at u v) <> 0.
Proof.
  intros Hw; destruct (common_place _ _ condition_not_zero Hw) as [t [s [Ht [Hs [F G]]]]].
  rewrite <- grid_at_horner2 in F, G.
  rewrite condition_value in F by lra; rewrite coordinate_value in G by lra.
  assert (unit : forall x, 0 < x -> 0 <= x / (1 + x) <= 1).
  { intros x Hx; split; [apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra] |].
    apply (Rmult_le_reg_r (1 + x)); [lra |]; replace (x / (1 + x) * (1 + x)) with x by (field; lra); lra. }
  exists (t / (1 + t)), (s / (1 + s)); repeat split; try (apply unit; assumption).
  - intros E; apply G; rewrite E; ring.
  - intros E; apply F; rewrite E; ring.
Qed.

(** In affine coordinates. *)
Lemma affine : forall u v, coordinate_at 3 u v <> 0 ->
  surface_at [coordinate_at 0 u v / coordinate_at 3 u v; coordinate_at 1 u v / coordinate_at 3 u v;
              coordinate_at 2 u v / coordinate_at 3 u v; 1]
  = (/ coordinate_at 3 u v) ^ degree * surface_at (coordinates_at u v).
Proof.
  intros u v H; unfold homogeneous in surface_homogeneous; apply andb_prop in surface_homogeneous as [_ Htotal].
  unfold surface_at; rewrite <- scaled_value by assumption; f_equal; cbn [map coordinates_at].
  repeat (apply (f_equal2 cons); [field; assumption |]); reflexivity.
Qed.

End Patch.
