(** ** A patch as polynomials in u and v *)

Section Exact.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.
Let roots := square_roots radicands.
Let are_roots : squares radicands roots := square_roots_square radicands radicands_nonnegative.

Variables (common : BinInt.Z) (net : net_terms).
Variables (degree : nat) (common_surface : BinInt.Z) (surface_terms : list term).

Definition one_minus (p : polynomial) : polynomial := minus_poly (constant (Int 1)) p.

Definition power_poly (p : polynomial) (e : nat) : polynomial :=
  power_A polynomial (times_poly radicands) constant p e.

(** What [combined] and [bezier] are to numbers. *)
Fixpoint combined_poly (n i : nat) (a : list polynomial) (t : polynomial) : polynomial :=
  match a with
  | [] => constant (Int 0)
  | first :: rest =>
      plus_poly
        (times_poly radicands
          (multiply_poly radicands (binomial n i) (times_poly radicands (power_poly t i) (power_poly (one_minus t) (n - i)))) first)
        (combined_poly n (S i) rest t)
  end.

Definition bezier_poly (a : list polynomial) (t : polynomial) : polynomial := combined_poly (length a - 1) 0 a t.

(** The parameters: variables, or constants along an edge. *)
Variables in_u in_v : polynomial.

Definition coordinate_poly (k : nat) : polynomial :=
  bezier_poly (map (fun row => bezier_poly (map (fun p => polynomial_of radicands common [] (entry k p)) row) in_v) net) in_u.

Definition condition_poly : polynomial :=
  polynomial_of radicands common_surface [coordinate_poly 0; coordinate_poly 1; coordinate_poly 2; coordinate_poly 3] surface_terms.

Definition identity : bool :=
  forallb (forallb (forallb (divides common))) net && negb (common =? 0)%Z
  && homogeneous degree common_surface surface_terms
  && Peq same condition_poly (constant (Int 0)).

Hypothesis checked : identity = true.

Variable parameters : list R.
Let at_ := at_values roots parameters.
Variables u v : R.
Hypothesis u_reads : at_ in_u = u.
Hypothesis v_reads : at_ in_v = v.

Lemma combined_poly_at : forall t n a i, at_ (combined_poly n i a t) = combined n i (map at_ a) (at_ t).
Proof.
  intros t n; unfold at_; induction a as [| first rest IH]; intros i; cbn [combined_poly combined map].
  - exact (at_int roots parameters 0).
  - unfold multiply_poly, power_poly, one_minus, bernstein.
    rewrite (at_plus radicands roots are_roots), IH, !(at_times radicands roots are_roots), (at_int roots).
    rewrite !(real_power polynomial (times_poly radicands) constant roots (at_values roots parameters)
                (at_times radicands roots are_roots parameters)) by reflexivity.
    rewrite (at_minus radicands roots are_roots), (at_int roots); ring.
Qed.

Lemma bezier_poly_at : forall a t, at_ (bezier_poly a t) = bezier (map at_ a) (at_ t).
Proof. intros; unfold bezier_poly, bezier; rewrite map_length; apply combined_poly_at. Qed.

Lemma coordinate_poly_at : forall k, forallb (forallb (forallb (divides common))) net = true ->
  at_ (coordinate_poly k) = IZR common * coordinate_at radicands net [] k u v.
Proof.
  intros k Hdivides; unfold coordinate_poly, coordinate_at; rewrite bezier_poly_at, map_map.
  rewrite u_reads.
  rewrite <- bezier_scale, map_map; f_equal; apply map_ext_in; intros row Irow.
  rewrite forallb_forall in Hdivides; specialize (Hdivides _ Irow); rewrite forallb_forall in Hdivides.
  rewrite bezier_poly_at, map_map.
  rewrite v_reads.
  rewrite <- bezier_scale, map_map; f_equal; apply map_ext_in; intros p Ip.
  unfold polynomial_of; rewrite (real_sum _ _ _ _ _ roots at_).
  - cbn [map]; rewrite spelled_value by assumption; reflexivity.
  - intros; apply (at_plus radicands roots are_roots).
  - intros; apply (at_times radicands roots are_roots).
  - exact (at_int roots parameters 0).
  - reflexivity.
  - apply entries_divide, Hdivides, Ip.
Qed.

Lemma condition_vanishes : surface_at radicands surface_terms (coordinates_at radicands net [] u v) = 0.
Proof.
  pose proof checked as H; unfold identity in H.
  apply andb_prop in H as [H Hzero]; apply andb_prop in H as [H Hhomogeneous]; apply andb_prop in H as [Hdivides Hcommon].
  unfold homogeneous in Hhomogeneous; apply andb_prop in Hhomogeneous as [H Htotal]; apply andb_prop in H as [Hsurface Hnonzero].
  apply negb_true_iff, Z.eqb_neq in Hcommon, Hnonzero.
  apply (at_same radicands roots are_roots parameters) in Hzero; rewrite (at_int roots) in Hzero.
  unfold condition_poly, polynomial_of in Hzero; rewrite (real_sum _ _ _ _ _ roots (at_values roots parameters)) in Hzero; try assumption.
  - cbn [map] in Hzero; fold at_ in Hzero; rewrite !coordinate_poly_at in Hzero by assumption.
    change [IZR common * coordinate_at radicands net [] 0 u v; IZR common * coordinate_at radicands net [] 1 u v;
            IZR common * coordinate_at radicands net [] 2 u v; IZR common * coordinate_at radicands net [] 3 u v]
      with (map (Rmult (IZR common)) (coordinates_at radicands net [] u v)) in Hzero.
    unfold roots in Hzero; rewrite (scaled_value radicands degree) in Hzero by assumption.
    apply Rmult_integral in Hzero as [E | E]; [apply eq_IZR in E; contradiction |].
    apply Rmult_integral in E as [E | E]; [| exact E].
    exfalso; revert E; apply pow_nonzero; intros E; apply eq_IZR in E; contradiction.
  - intros; apply (at_plus radicands roots are_roots).
  - intros; apply (at_times radicands roots are_roots).
  - exact (at_int roots parameters 0).
  - reflexivity.
Qed.

Variable real_net : list (list point).
Hypothesis net_reads : net_of radicands [] net = real_net.
Variable surface : R -> R -> R -> R -> R.
Hypothesis surface_reads : forall x y z w, spelled radicands [x; y; z; w] surface_terms = surface x y z w.

Theorem on_the_surface : patch W real_net u v <> 0 -> lies_on surface real_net u v.
Proof.
  unfold lies_on; destruct (patch_coordinate radicands net [] real_net net_reads u v) as [Px [Py [Pz Pw]]].
  rewrite <- Px, <- Py, <- Pz, <- Pw, <- surface_reads, spelled_value by assumption; intros D.
  pose proof checked as H; unfold identity in H; apply andb_prop in H as [H _]; apply andb_prop in H as [_ Hhomogeneous].
  pose proof (affine radicands net degree common_surface surface_terms [] Hhomogeneous u v D) as Q.
  unfold surface_at in Q; rewrite Q; pose proof condition_vanishes as C; unfold surface_at in C; rewrite C; ring.
Qed.

End Exact.
