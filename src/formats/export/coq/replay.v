(** ** A patch as a grid of polynomials, and the replay of a certificate *)

Inductive premise := c (r s : nat) | f (k : nat) | nonzero (k : nat) | step (k : nat).

(** A step: the sum of multiplier times premise is a non-zero integer times the conclusion. *)
Record derivation := Derive { summands : list (premise * list term); multiple : BinInt.Z; conclusion : list term }.

Section Claim.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.
Let roots := square_roots radicands.
Let are_roots : squares radicands roots := square_roots_square radicands radicands_nonnegative.

Definition plus_row := plus_list polynomial plus_poly.
Definition times_row := times_list polynomial plus_poly (times_poly radicands) (constant (Int 0)).
Definition plus_grid := plus_list (list polynomial) plus_row.
Definition times_grid := times_list (list polynomial) plus_row times_row [].
Definition multiply_poly (k : BinInt.Z) : polynomial -> polynomial := times_poly radicands (constant (Int k)).

Definition polynomial_of (common : BinInt.Z) (variables : list polynomial) (terms : list term) : polynomial :=
  sum_A polynomial plus_poly (times_poly radicands) (constant (Int 0)) constant common variables terms.

Definition variables (count : nat) : list polynomial := map variable (seq 0 count).

Variable values : list R.
Let at_ := at_values roots values.

Lemma at_zero : at_ (constant (Int 0)) = 0.
Proof. unfold at_; rewrite at_int; reflexivity. Qed.

Lemma variables_at : map at_ (variables (length values)) = values.
Proof.
  unfold variables; rewrite map_map; unfold at_.
  assert (shift : forall l before, map (fun k => at_values roots (before ++ l) (variable k)) (seq (length before) (length l)) = l).
  { induction l as [| x l IH]; intros before; simpl; [reflexivity |].
    rewrite at_variable, app_nth2, Nat.sub_diag by lia; f_equal.
    specialize (IH (before ++ [x])); rewrite app_length, <- app_assoc in IH; simpl in IH.
    rewrite Nat.add_1_r in IH; exact IH. }
  exact (shift values []).
Qed.

Lemma polynomial_of_value : forall common terms, divides common terms = true ->
  at_ (polynomial_of common (variables (length values)) terms) = IZR common * spelled radicands values terms.
Proof.
  intros common terms H; unfold polynomial_of.
  rewrite real_sum with (roots := roots) (real := at_); try assumption.
  - rewrite variables_at, spelled_value by assumption; reflexivity.
  - intros; apply (at_plus radicands roots are_roots).
  - intros; apply (at_times radicands roots are_roots).
  - exact at_zero.
  - reflexivity.
Qed.

(** *** The replay *)

Variable given : premise -> polynomial.
Hypothesis given_vanish : forall p, at_ (given p) = 0.

Definition lookup (proved : list polynomial) (p : premise) : polynomial :=
  match p with
  | step k => nth (k - 1) proved (constant (Int 0))
  | _ => given p
  end.

Definition integral (count : nat) (terms : list term) : polynomial := polynomial_of 1 (variables count) terms.

Definition combination (count : nat) (proved : list polynomial) (l : list (premise * list term)) : polynomial :=
  fold_right (fun summand sum => plus_poly (times_poly radicands (integral count (snd summand)) (lookup proved (fst summand))) sum)
    (constant (Int 0)) l.

Definition follows (count : nat) (proved : list polynomial) (d : derivation) : bool :=
  negb (multiple d =? 0)%Z
  && Peq same (combination count proved (summands d)) (multiply_poly (multiple d) (integral count (conclusion d))).

Fixpoint replay (count : nat) (proved : list polynomial) (certificate : list derivation) : bool :=
  match certificate with
  | [] =>
      match last proved (constant (Int 0)) with
      | Pc (Int n) => negb (n =? 0)%Z
      | _ => false
      end
  | d :: rest => follows count proved d && replay count (proved ++ [integral count (conclusion d)]) rest
  end.

Lemma lookup_vanishes : forall proved p, Forall (fun q => at_ q = 0) proved -> at_ (lookup proved p) = 0.
Proof.
  intros proved p H; destruct p; simpl; try apply given_vanish.
  rewrite Forall_forall in H.
  destruct (nth_in_or_default (k - 1) proved (constant (Int 0))) as [I | E]; [apply H, I | rewrite E; exact at_zero].
Qed.

Lemma combination_vanishes : forall count proved l, Forall (fun q => at_ q = 0) proved -> at_ (combination count proved l) = 0.
Proof.
  intros count proved l H; induction l as [| [p m] rest IH]; simpl; [exact at_zero |].
  unfold at_ in *; rewrite (at_plus radicands roots are_roots), (at_times radicands roots are_roots).
  rewrite IH; pose proof (lookup_vanishes proved p H) as L; unfold at_ in L; rewrite L; ring.
Qed.

Lemma replay_refutes : forall count certificate proved,
  Forall (fun q => at_ q = 0) proved -> replay count proved certificate = true -> False.
Proof.
  intros count; induction certificate as [| d rest IH]; intros proved H R; simpl in R.
  - destruct (last proved (constant (Int 0))) as [[n | a b] | j q | q i q'] eqn:E; try discriminate.
    apply negb_true_iff, Z.eqb_neq in R; apply R, eq_IZR; rewrite <- (at_int roots values n).
    unfold constant; rewrite <- E; destruct proved as [| q l]; [exact at_zero |].
    rewrite Forall_forall in H; apply H; clear -l; revert q; induction l as [| q' l IH]; intros q; simpl; [left; reflexivity |].
    right; apply IH.
  - apply andb_prop in R as [F R]; apply (IH _) in R; [exact R | clear IH R].
    apply Forall_app; split; [assumption | constructor; [| constructor]].
    apply andb_prop in F as [M F]; apply negb_true_iff, Z.eqb_neq in M.
    apply (at_same radicands roots are_roots values) in F.
    change (at_ (combination count proved (summands d)) = at_ (multiply_poly (multiple d) (integral count (conclusion d)))) in F.
    rewrite combination_vanishes in F by assumption.
    unfold at_, multiply_poly in F; rewrite (at_times radicands roots are_roots), at_int in F.
    symmetry in F; apply Rmult_integral in F as [F | F]; [apply eq_IZR in F; contradiction | exact F].
Qed.

End Claim.
