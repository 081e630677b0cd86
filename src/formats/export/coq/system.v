(** ** Systems of equations *)

Section System.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.
Let roots := square_roots radicands.
Let are_roots : squares radicands roots := square_roots_square radicands radicands_nonnegative.
Variables (count : nat) (common : BinInt.Z) (equation_terms : list (list term)).
Variables (common_assumptions : BinInt.Z) (assumptions : list (list term * nat)) (certificate : list derivation).

Definition equation_polynomials : list polynomial := map (polynomial_of radicands common (variables count)) equation_terms.

Definition system_given (equations : list polynomial) (p : premise) : polynomial :=
  match p with
  | f k => nth (k - 1) equations (constant (Int 0))
  | nonzero k => nth (k - 1) (map (assumption_polynomial radicands count common_assumptions) assumptions) (constant (Int 0))
  | _ => constant (Int 0)
  end.

Definition system_refuted : bool :=
  forallb (divides common) equation_terms && forallb (fun a => divides common_assumptions (fst a)) assumptions
  && (let equations := equation_polynomials in replay radicands (system_given equations) count [] certificate).

Hypothesis checked : system_refuted = true.

Variable values : list R.
Hypothesis values_count : length values = count.
Hypothesis inverses : Forall (fun a => spelled radicands values (fst a) * nth (snd a) values 0 = 1) assumptions.
Variable equations : list R.
Hypothesis equations_read : map (spelled radicands values) equation_terms = equations.

Theorem an_equation_fails : Exists (fun e => e <> 0) equations.
Proof.
  destruct (Forall_Exists_dec (fun e => e = 0) (fun e => Req_EM_T e 0) equations) as [Zero | Some]; [exfalso | exact Some].
  pose proof checked as H; unfold system_refuted in H.
  apply andb_prop in H as [H Hreplay]; apply andb_prop in H as [Hdivides Hintegral].
  rewrite forallb_forall in Hdivides; rewrite <- equations_read in Zero; apply (proj1 (Forall_map _ _ _)) in Zero.
  apply (replay_refutes radicands radicands_nonnegative values (system_given equation_polynomials)) with (2 := Forall_nil _) (3 := Hreplay).
  intros p; destruct p as [r s | k | k | k]; cbn [system_given]; try exact (at_int roots values 0).
  - apply nth_zero; [exact (at_int roots values 0) |].
    apply Forall_map; rewrite Forall_forall in *; intros terms I.
    pose proof (polynomial_of_value radicands radicands_nonnegative values common terms (Hdivides _ I)) as P.
    rewrite values_count in P; rewrite P, (Zero _ I); ring.
  - apply nth_zero; [exact (at_int roots values 0) |].
    apply (assumptions_vanish radicands radicands_nonnegative count values values_count common_assumptions assumptions Hintegral inverses).
Qed.

End System.

(** The values of equations without unknowns. *)
Section Solution.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.

Definition number_vanishes (common : BinInt.Z) (terms : list term) : bool :=
  divides common terms && negb (common =? 0)%Z && Peq same (polynomial_of radicands common [] terms) (constant (Int 0)).

Lemma vanishing_number : forall common terms, number_vanishes common terms = true -> spelled radicands [] terms = 0.
Proof.
  intros common terms H; unfold number_vanishes in H.
  apply andb_prop in H as [H E]; apply andb_prop in H as [D N]; apply negb_true_iff, Z.eqb_neq in N.
  apply (at_same radicands (square_roots radicands) (square_roots_square radicands radicands_nonnegative) []) in E.
  rewrite (at_int (square_roots radicands)) in E.
  pose proof (polynomial_of_value radicands radicands_nonnegative [] common terms D) as P; cbn [length variables map seq] in P.
  change (variables 0) with (@nil polynomial) in P; rewrite P in E.
  apply Rmult_integral in E as [E | E]; [apply eq_IZR in E; contradiction | exact E].
Qed.

Lemma vanishing_numbers : forall common equations real_equations,
  map (spelled radicands []) equations = real_equations -> forallb (number_vanishes common) equations = true ->
  Forall (fun e => e = 0) real_equations.
Proof.
  intros common equations real_equations <- H; apply Forall_map; rewrite Forall_forall; rewrite forallb_forall in H.
  intros terms I; exact (vanishing_number common terms (H terms I)).
Qed.

End Solution.
