(** ** The theorem, for any net *)

Lemma binomial_positive : forall n k, (k <= n)%nat -> (0 < binomial n k)%Z.
Proof.
  assert (nonnegative : forall n k, (0 <= binomial n k)%Z).
  { induction n as [| n IH]; intros [| k]; cbn [binomial]; try lia; pose proof (IH k); pose proof (IH (S k)); lia. }
  induction n as [| n IH]; intros [| k] H; cbn [binomial]; try lia.
  pose proof (IH k ltac:(lia)); pose proof (nonnegative n (S k)); lia.
Qed.

Lemma weighted_zero : forall (A : Type) multiply (P : A -> Prop) n,
  (forall k a, (0 < k)%Z -> P (multiply k a) -> P a) ->
  forall l i, (i + length l <= S n)%nat -> Forall P (weighted multiply n i l) -> Forall P l.
Proof.
  intros A multiply P n H; induction l as [| a l IH]; intros i Hi F; [constructor |].
  simpl in Hi; inversion F as [| b l' Ha Hl]; subst; constructor.
  - apply (H (binomial n i)); [apply binomial_positive; lia | exact Ha].
  - apply (IH (S i)); [lia | exact Hl].
Qed.

Section Impossible.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.
Let roots := square_roots radicands.
Variables (m n count : nat) (common : BinInt.Z) (net : net_terms).
Variables (degree : nat) (common_surface : BinInt.Z) (surface_terms : list term).
Variables (common_assumptions : BinInt.Z) (assumptions : list (list term * nat)) (certificate : list derivation).

Hypothesis checked :
  refuted radicands m n count common net degree common_surface surface_terms common_assumptions assumptions certificate = true.

Variable values : list R.
Hypothesis values_count : length values = count.
Hypothesis inverses : Forall (fun a => spelled radicands values (fst a) * nth (snd a) values 0 = 1) assumptions.
Variable real_net : list (list point).
Hypothesis net_reads : net_of radicands values net = real_net.
Variable surface : R -> R -> R -> R -> R.
Hypothesis surface_reads : forall x y z w, spelled radicands [x; y; z; w] surface_terms = surface x y z w.

(** A weight that is a constant, with a multiplier that makes it a non-zero integer. *)
Definition weight_known (i j : nat) (multiplier : list term) (k : BinInt.Z) : bool :=
  negb (k =? 0)%Z
  && Peq same
       (times_poly radicands (nth j (nth i (coordinate_grid radicands m n count common net 3) []) (constant (Int 0)))
          (integral radicands count multiplier))
       (constant (Int k)).

Lemma weight_is_known : forall i j multiplier k, weight_known i j multiplier k = true ->
  ~ all_zero (map (map (at_values roots values)) (coordinate_grid radicands m n count common net 3)).
Proof.
  intros i j multiplier k K Zero; unfold weight_known in K; apply andb_prop in K as [K product_is]; apply negb_true_iff, Z.eqb_neq in K; apply K.
  set (grid := coordinate_grid radicands m n count common net 3) in *.
  assert (vanishes : at_values roots values (nth j (nth i grid []) (constant (Int 0))) = 0).
  { apply nth_zero; [exact (at_int roots values 0) |].
    destruct (nth_in_or_default i grid []) as [I | E]; [| rewrite E; constructor].
    apply (in_map (map (at_values roots values))) in I; unfold all_zero in Zero; rewrite Forall_forall in Zero.
    apply Zero, Forall_map in I; exact I. }
  apply (at_same radicands roots (square_roots_square radicands radicands_nonnegative) values) in product_is.
  rewrite (at_times radicands roots (square_roots_square radicands radicands_nonnegative)), vanishes, Rmult_0_l, (at_int roots)
    in product_is.
  symmetry in product_is; apply eq_IZR in product_is; exact product_is.
Qed.

(** Or else it is assumed that the weights are not all zero. *)
Lemma weight_is_assumed : Exists (Exists (fun p => W p <> 0)) real_net ->
  ~ all_zero (map (map (at_values roots values)) (coordinate_grid radicands m n count common net 3)).
Proof.
  intros some Zero; pose proof checked as H; unfold refuted in H.
  apply andb_prop in H as [H _]; apply andb_prop in H as [H _]; apply andb_prop in H as [H _]; unfold regular in H.
  apply andb_prop in H as [H Hcommon]; apply andb_prop in H as [H Hdivides]; apply andb_prop in H as [Hrows Hlengths].
  apply negb_true_iff, Z.eqb_neq in Hcommon; apply Nat.eqb_eq in Hrows; rewrite forallb_forall in Hdivides, Hlengths.
  rewrite <- net_reads in some; apply Exists_exists in some as [row [Irow some]].
  apply in_map_iff in Irow as [row' [<- Irow]]; apply Exists_exists in some as [p [Ip some]].
  apply in_map_iff in Ip as [p' [<- Ip]]; apply some; cbn [W point_of].
  assert (nonzero_factor : forall k a, (0 < k)%Z ->
    at_values roots values (multiply_poly radicands k a) = 0 -> at_values roots values a = 0).
  { intros k a Hk E; unfold multiply_poly in E.
    rewrite (at_times radicands roots (square_roots_square radicands radicands_nonnegative)), (at_int roots) in E.
    apply Rmult_integral in E as [E | E]; [apply eq_IZR in E; lia | exact E]. }
  unfold all_zero, coordinate_grid in Zero; apply (proj1 (Forall_map _ _ _)) in Zero.
  apply weighted_zero in Zero.
  - apply (proj1 (Forall_map _ _ _)) in Zero; rewrite Forall_forall in Zero; specialize (Zero _ Irow); cbv beta in Zero.
    apply (proj1 (Forall_map _ _ _)) in Zero; apply weighted_zero in Zero.
    + apply (proj1 (Forall_map _ _ _)) in Zero; rewrite Forall_forall in Zero; specialize (Zero _ Ip); cbv beta in Zero.
      specialize (Hdivides _ Irow); rewrite forallb_forall in Hdivides; specialize (Hdivides _ Ip).
      rewrite <- values_count in Zero.
      pose proof (polynomial_of_value radicands radicands_nonnegative values common (entry 3 p')
        (entries_divide common 3 p' Hdivides)) as P.
      fold roots in P; rewrite P in Zero; apply Rmult_integral in Zero as [E | E]; [apply eq_IZR in E; contradiction | exact E].
    + exact nonzero_factor.
    + rewrite map_length; specialize (Hlengths _ Irow); apply Nat.eqb_eq in Hlengths; lia.
  - intros k row Hk F; apply (proj1 (Forall_map _ _ _)) in F; apply (proj1 (Forall_map _ _ _)) in F; apply (proj2 (Forall_map _ _ _)).
    revert F; apply Forall_impl; intros a; apply nonzero_factor; assumption.
  - rewrite map_length; lia.
Qed.

Lemma patch_coordinate : forall u v,
  coordinate_at radicands net values 0 u v = patch X real_net u v
  /\ coordinate_at radicands net values 1 u v = patch Y real_net u v
  /\ coordinate_at radicands net values 2 u v = patch Z real_net u v
  /\ coordinate_at radicands net values 3 u v = patch W real_net u v.
Proof.
  intros u v; rewrite <- net_reads; unfold patch, coordinate_at, net_of.
  repeat split; rewrite map_map; f_equal; apply map_ext; intros row; rewrite map_map; reflexivity.
Qed.

Theorem misses_the_surface :
  ~ all_zero (map (map (at_values roots values)) (coordinate_grid radicands m n count common net 3)) ->
  exists u v, 0 <= u <= 1 /\ 0 <= v <= 1 /\ patch W real_net u v <> 0 /\ ~ lies_on surface real_net u v.
Proof.
  intros weight; pose proof checked as H; unfold refuted in H.
  apply andb_prop in H as [H Hreplay]; apply andb_prop in H as [H Hintegral]; apply andb_prop in H as [Hregular Hhomogeneous].
  destruct (misses radicands radicands_nonnegative m n count common net degree common_surface surface_terms values values_count
              Hregular Hhomogeneous common_assumptions assumptions certificate Hreplay Hintegral inverses weight) as [u [v [Hu [Hv [D F]]]]].
  exists u, v; unfold lies_on; destruct (patch_coordinate u v) as [Px [Py [Pz Pw]]]; rewrite <- Px, <- Py, <- Pz, <- Pw.
  repeat split; try assumption; try apply Hu; try apply Hv.
  rewrite <- surface_reads, spelled_value by assumption.
  intros E; pose proof (affine radicands net degree common_surface surface_terms values Hhomogeneous u v D) as Q.
  unfold surface_at in Q; rewrite E in Q.
  symmetry in Q; apply Rmult_integral in Q as [Q | Q]; [| exact (F Q)].
  revert Q; apply pow_nonzero, Rinv_neq_0_compat, D.
Qed.

End Impossible.
