(** Stereographic cap bounded by four small circles, biquadratic, centre unknown

    Every point of this patch lies on the surface: [on_the_surface], at the end of this file.
    W is positive on the whole square, so that the patch is defined there: [weight_is_positive].
    The edges u = 0, u = 1, v = 0, v = 1 lie in their planes: [edge_...].
    The unknowns of the statement have these values, put in by prove-cap before Coq reads the file: X11 is 0; Y11 is 0; Z11 is 3 / 2; W11 is 1 / 2.

    Part 1 and part 4 are to be read: what is defined, and what is proved of it. Part 2 is a checker of certificates with the proof
    that it is right; part 3 is a certificate. Coq verifies all of it:  coqc FILE.v  (written for Coq 8.16; no library but its own).
    To read it: R are the real numbers, f x y is f(x, y), [a; b] a list, /\ is and, ~ not, <> not equal, -> implies.
    The last lines print the axioms that the theorems rest on: those of Coq's real numbers.

    Written by prove-cap; statement sha256 485d3451a207aa3e21c90bd6d39dc2afd7172663ed3c100e883de26c1c5f50b9 *)

(** * 1. Definitions *)

From Coq Require Import Reals Lra Lia List ZArith Bool Ring_polynom.
Import ListNotations.
Open Scope R_scope.

(** Binomial coefficients, by Pascal's rule. *)
Fixpoint binomial (n k : nat) : Z :=
  match n, k with
  | _, O => 1%Z
  | O, S _ => 0%Z
  | S n', S k' => (binomial n' k' + binomial n' k)%Z
  end.

(** The Bernstein polynomial B_i^n(t) = C(n,i) t^i (1-t)^(n-i). *)
Definition bernstein (n i : nat) (t : R) : R :=
  IZR (binomial n i) * t ^ i * (1 - t) ^ (n - i).

(** B_i^n(t) a_0 + B_(i+1)^n(t) a_1 + ... *)
Fixpoint combined (n i : nat) (a : list R) (t : R) : R :=
  match a with
  | [] => 0
  | first :: rest => bernstein n i t * first + combined n (S i) rest t
  end.

(** The Bezier polynomial with coefficients a_0, ..., a_n. *)
Definition bezier (a : list R) (t : R) : R := combined (length a - 1) 0 a t.

(** A control point in homogeneous coordinates: (X, Y, Z, W) = (w x, w y, w z, w) for the point (x, y, z) with weight w. *)
Record point := Point { X : R; Y : R; Z : R; W : R }.

(** A coordinate of the patch: the sum of B_i^m(u) B_j^n(v) times the coordinate of the control point in row i, place j. *)
Definition patch (coordinate : point -> R) (net : list (list point)) (u v : R) : R :=
  bezier (map (fun row => bezier (map coordinate row) v) net) u.

(** The point of the patch, where W is not zero, lies on the surface. *)
Definition lies_on (surface : R -> R -> R -> R -> R) (net : list (list point)) (u v : R) : Prop :=
  surface (patch X net u v / patch W net u v) (patch Y net u v / patch W net u v) (patch Z net u v / patch W net u v) 1 = 0.

(** The control net: rows 0 to 2 along u, in each the points 0 to 2 along v. *)
Definition net : list (list point) :=
  [[Point (-1) (-1) (1 / 2) (3 / 2);
    Point (-1) 0 1 1;
    Point (-1) 1 (1 / 2) (3 / 2)];
   [Point 0 (-1) 1 1;
    Point 0 0 (3 / 2) (1 / 2);
    Point 0 1 1 1];
   [Point 1 (-1) (1 / 2) (3 / 2);
    Point 1 0 1 1;
    Point 1 1 (1 / 2) (3 / 2)]].

(** The surface: where this is zero. *)
Definition surface (X Y Z W : R) : R := X ^ 2 + Y ^ 2 + Z ^ 2 - W ^ 2.

(** The plane of the edge u = 0: where this is zero. *)
Definition plane_u0 (X Y Z W : R) : R := X + 1 / 2 * Z + 1 / 2 * W.

(** The plane of the edge u = 1: where this is zero. *)
Definition plane_u1 (X Y Z W : R) : R := X - 1 / 2 * Z - 1 / 2 * W.

(** The plane of the edge v = 0: where this is zero. *)
Definition plane_v0 (X Y Z W : R) : R := Y + 1 / 2 * Z + 1 / 2 * W.

(** The plane of the edge v = 1: where this is zero. *)
Definition plane_v1 (X Y Z W : R) : R := Y - 1 / 2 * Z - 1 / 2 * W.

(** * 2. A checker of certificates, proved correct *)

Module Replay.

(** ** Numbers: integers with square roots.

    [Ext a b] is a + b r, where r is the first of the remaining roots. *)

(** A long integer from groups of 18 digits: Coq reads long decimals slowly. *)
Definition long (groups : list BinInt.Z) : BinInt.Z := fold_left (fun n group => (n * 1000000000000000000 + group)%Z) groups 0%Z.

Inductive number := Int (n : BinInt.Z) | Ext (a b : number).

Fixpoint value (roots : list R) (x : number) : R :=
  match x, roots with
  | Int n, _ => IZR n
  | Ext a b, r :: rest => value rest a + r * value rest b
  | Ext a _, [] => value [] a
  end.

Fixpoint add_int (m : BinInt.Z) (x : number) : number :=
  match x with Int n => Int (m + n) | Ext a b => Ext (add_int m a) b end.

Fixpoint add (x y : number) : number :=
  match x, y with
  | Int m, _ => add_int m y
  | Ext _ _, Int n => add_int n x
  | Ext a b, Ext c d => Ext (add a c) (add b d)
  end.

Fixpoint scale (m : BinInt.Z) (x : number) : number :=
  match x with Int n => Int (m * n) | Ext a b => Ext (scale m a) (scale m b) end.

Fixpoint times (radicands : list BinInt.Z) (x y : number) : number :=
  match x, y with
  | Int m, _ => scale m y
  | Ext _ _, Int n => scale n x
  | Ext a b, Ext c d =>
      match radicands with
      | [] => times [] a c
      | e :: rest =>
          Ext (add (times rest a c) (scale e (times rest b d)))
              (add (times rest a d) (times rest b c))
      end
  end.

Definition negative (x : number) : number := scale (-1) x.
Definition minus (x y : number) : number := add x (negative y).

Fixpoint is_zero (x : number) : bool :=
  match x with Int n => (n =? 0)%Z | Ext a b => is_zero a && is_zero b end.

Definition same (x y : number) : bool := is_zero (minus x y).

Lemma value_int : forall roots n, value roots (Int n) = IZR n.
Proof. intros [| r roots] n; reflexivity. Qed.

Lemma value_add_int : forall x m roots, value roots (add_int m x) = IZR m + value roots x.
Proof.
  induction x as [n | a IHa b IHb]; intros m [| r rest]; simpl;
    rewrite ?plus_IZR, ?IHa; ring.
Qed.

Lemma value_add : forall x y roots, value roots (add x y) = value roots x + value roots y.
Proof.
  induction x as [m | a IHa b IHb]; intros y roots.
  - cbn [add]; rewrite value_add_int; destruct roots; reflexivity.
  - destruct y as [n | c d]; cbn [add].
    + rewrite value_add_int; destruct roots; simpl; ring.
    + destruct roots as [| r rest]; cbn [value]; rewrite ?IHa, ?IHb; ring.
Qed.

Lemma value_scale : forall x m roots, value roots (scale m x) = IZR m * value roots x.
Proof.
  induction x as [n | a IHa b IHb]; intros m [| r rest]; simpl;
    rewrite ?mult_IZR, ?IHa, ?IHb; ring.
Qed.

Lemma value_zero : forall x roots, is_zero x = true -> value roots x = 0.
Proof.
  induction x as [n | a IHa b IHb]; intros roots H; simpl in H.
  - apply Z.eqb_eq in H; subst; reflexivity.
  - apply andb_prop in H as [Ha Hb].
    destruct roots as [| r rest]; simpl; rewrite ?(IHa _ Ha), ?(IHb _ Hb); ring.
Qed.

(** The roots of radicands are square roots. *)
Inductive squares : list BinInt.Z -> list R -> Prop :=
  | squares_nil : squares [] []
  | squares_cons : forall e radicands r roots,
      r * r = IZR e -> squares radicands roots -> squares (e :: radicands) (r :: roots).

Lemma value_times : forall radicands roots, squares radicands roots -> forall x y,
  value roots (times radicands x y) = value roots x * value roots y.
Proof.
  intros radicands roots H x; revert radicands roots H.
  induction x as [m | a IHa b IHb]; intros radicands roots H y.
  - cbn [times]; rewrite value_scale; destruct roots; reflexivity.
  - destruct y as [n | c d]; cbn [times]; [rewrite value_scale; destruct roots; simpl; ring |].
    destruct H as [| e radicands r roots Hr H]; cbn [value].
    + rewrite (IHa [] [] squares_nil); reflexivity.
    + rewrite !value_add, value_scale, !(IHa _ _ H), !(IHb _ _ H), <- Hr; ring.
Qed.

(** ** Polynomials with such coefficients, from the standard library's [Ring_polynom]. *)

Definition polynomial := Pol number.

Section Polynomials.

Variable radicands : list BinInt.Z.
Variable roots : list R.
Hypothesis are_roots : squares radicands roots.

Lemma morphism :
  ring_morph 0 1 Rplus Rmult Rminus Ropp eq (Int 0) (Int 1) add (times radicands) minus negative same (value roots).
Proof.
  unfold minus, negative, same, minus, negative; constructor; intros.
  - destruct roots; reflexivity.
  - destruct roots; reflexivity.
  - apply value_add.
  - rewrite value_add, value_scale; ring.
  - apply value_times; assumption.
  - rewrite value_scale; ring.
  - apply value_zero with (roots := roots) in H; rewrite value_add, value_scale in H; lra.
Qed.

Definition plus_poly : polynomial -> polynomial -> polynomial := Padd (Int 0) add same.
Definition minus_poly : polynomial -> polynomial -> polynomial := Psub (Int 0) add minus negative same.
Definition times_poly : polynomial -> polynomial -> polynomial := Pmul (Int 0) (Int 1) add (times radicands) same.
Definition constant : number -> polynomial := @Pc number.

(** The variable number k, from 0. *)
Fixpoint variable (k : nat) : polynomial :=
  match k with
  | O => mkX (Int 0) (Int 1)
  | S k' => mkPinj 1 (variable k')
  end.

(** The value of a polynomial, where its variables have the values in a list. *)
Definition at_values (values : list R) (p : polynomial) : R := Pphi 0 Rplus Rmult (value roots) values p.

Definition ring_axioms := Rth_ARth (Eqsth R) (Eq_ext Rplus Rmult Ropp) RTheory.

Lemma at_plus : forall l p q, at_values l (plus_poly p q) = at_values l p + at_values l q.
Proof. intros; exact (Padd_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_axioms morphism q p l). Qed.

Lemma at_minus : forall l p q, at_values l (minus_poly p q) = at_values l p - at_values l q.
Proof. intros; exact (Psub_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_axioms morphism q p l). Qed.

Lemma at_times : forall l p q, at_values l (times_poly p q) = at_values l p * at_values l q.
Proof. intros; exact (Pmul_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_axioms morphism p q l). Qed.

Lemma at_constant : forall l c, at_values l (constant c) = value roots c.
Proof. reflexivity. Qed.

Lemma at_int : forall l n, at_values l (constant (Int n)) = IZR n.
Proof. intros l n; exact (value_int roots n). Qed.

Lemma at_variable : forall k l, at_values l (variable k) = nth k l 0.
Proof.
  induction k as [| k IH]; intros [| x l]; unfold at_values in *.
  - cbn -[value]; rewrite !value_int; ring.
  - cbn -[value]; rewrite !value_int; ring.
  - cbn [variable]; rewrite (mkPinj_ok 0 Rplus Rmult (Eqsth R)); cbn [BinList.jump tl]; fold (at_values [] (variable k)); rewrite IH; destruct k; reflexivity.
  - cbn [variable]; rewrite (mkPinj_ok 0 Rplus Rmult (Eqsth R)); cbn [BinList.jump tl]; apply IH.
Qed.

Lemma at_same : forall l p q, Peq same p q = true -> at_values l p = at_values l q.
Proof. intros l p q H; exact (Peq_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) morphism p q H l). Qed.

End Polynomials.

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

(** ** Positive weights *)

(** Whether a number is positive: of a + b r with different signs the larger square decides. *)
Fixpoint positive (radicands : list BinInt.Z) (x : number) : bool :=
  match x, radicands with
  | Int n, _ => (0 <? n)%Z
  | Ext _ _, [] => false
  | Ext a b, d :: rest =>
      let difference := minus (times rest a a) (scale d (times rest b b)) in
      (positive rest a && (is_zero b || positive rest b))
      || (is_zero a && positive rest b && (0 <? d)%Z)
      || (positive rest a && positive rest (negative b) && positive rest difference)
      || (positive rest (negative a) && positive rest b && positive rest (negative difference))
  end.

Lemma positive_value : forall radicands, nonnegative radicands = true ->
  forall x, positive radicands x = true -> 0 < value (square_roots radicands) x.
Proof.
  induction radicands as [| d rest IH]; intros Hn x H.
  - destruct x as [n | a b]; simpl in H; [| discriminate].
    rewrite value_int; apply IZR_lt, Z.ltb_lt; exact H.
  - destruct x as [n | a b]; [rewrite value_int; apply IZR_lt, Z.ltb_lt; exact H |].
    unfold nonnegative in Hn; cbn [forallb] in Hn; apply andb_prop in Hn as [Hd Hn]; apply Z.leb_le, IZR_le in Hd.
    specialize (IH Hn); pose proof (square_roots_square rest Hn) as Hs.
    cbn [square_roots map value]; fold (square_roots rest).
    pose proof (sqrt_pos (IZR d)) as Hr; pose proof (sqrt_sqrt (IZR d) Hd) as Hsquare.
    set (r := sqrt (IZR d)) in *.
    cbn [positive] in H; apply orb_prop in H as [H | H]; [apply orb_prop in H as [H | H]; [apply orb_prop in H as [H | H] |] |].
    + apply andb_prop in H as [Ha Hb]; apply IH in Ha; apply orb_prop in Hb as [Hb | Hb].
      * rewrite (value_zero b) by assumption; lra.
      * apply IH in Hb; nra.
    + apply andb_prop in H as [H Hd']; apply andb_prop in H as [Ha Hb]; apply IH in Hb; apply Z.ltb_lt, IZR_lt in Hd'.
      rewrite (value_zero a) by assumption; assert (0 < r) by nra; nra.
    + apply andb_prop in H as [H Hdiff]; apply andb_prop in H as [Ha Hb]; apply IH in Ha, Hb, Hdiff.
      unfold minus, negative in *; rewrite value_add, !value_scale, !(value_times rest _ Hs) in Hdiff; rewrite value_scale in Hb.
      set (A := value (square_roots rest) a) in *; set (B := value (square_roots rest) b) in *.
      assert (square : (r * - B) * (r * - B) = IZR d * (B * B)) by (rewrite <- Hsquare; ring).
      apply Rnot_le_lt; intros L; assert (A * A <= (r * - B) * (r * - B)) by (apply Rmult_le_compat; lra); lra.
    + apply andb_prop in H as [H Hdiff]; apply andb_prop in H as [Ha Hb]; apply IH in Ha, Hb, Hdiff.
      unfold minus, negative in *; rewrite !value_scale, value_add, !value_scale, !(value_times rest _ Hs) in Hdiff; rewrite value_scale in Ha.
      set (A := value (square_roots rest) a) in *; set (B := value (square_roots rest) b) in *.
      assert (square : (r * B) * (r * B) = IZR d * (B * B)) by (rewrite <- Hsquare; ring).
      assert (0 <= r * B) by (apply Rmult_le_pos; lra).
      apply Rnot_le_lt; intros L; assert ((r * B) * (r * B) <= - A * - A) by (apply Rmult_le_compat; lra); lra.
Qed.

Lemma bezier_positive : forall a t, 0 <= t <= 1 -> a <> [] -> Forall (Rlt 0) a -> 0 < bezier a t.
Proof.
  intros a t Ht Ha F; unfold bezier.
  assert (weight : forall n i, (i <= n)%nat -> 0 <= bernstein n i t /\ (0 < t < 1 -> 0 < bernstein n i t)).
  { intros n i Hi; unfold bernstein; pose proof (binomial_positive n i Hi) as Hb; apply IZR_lt in Hb; split.
    - apply Rmult_le_pos; [apply Rmult_le_pos; [lra |] |]; apply pow_le; lra.
    - intros Ho; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [exact Hb |] |]; apply pow_lt; lra. }
  assert (rest : forall n l i, (i + length l = S n)%nat -> Forall (Rlt 0) l -> 0 <= combined n i l t
            /\ (0 < t < 1 -> l <> [] -> 0 < combined n i l t)).
  { intros n; induction l as [| b l IH]; intros i Hi Fl; cbn [combined length] in *.
    - split; [lra | intros _ E; contradiction].
    - inversion Fl as [| b' l' Hb Hl]; subst; destruct (IH (S i) ltac:(lia) Hl) as [I1 _].
      destruct (weight n i ltac:(lia)) as [W1 W2]; split.
      + pose proof (Rmult_le_pos _ _ W1 (Rlt_le _ _ Hb)); lra.
      + intros Ho _; pose proof (Rmult_lt_0_compat _ _ (W2 Ho) Hb); lra. }
  assert (Hlength : (0 + length a = S (length a - 1))%nat) by (destruct a; [contradiction | simpl; lia]).
  destruct (Req_dec t 0) as [-> | H0]; [| destruct (Req_dec t 1) as [-> | H1]].
  - destruct a as [| b l]; [contradiction |]; inversion F as [| b' l' Hb Hl]; subst; cbn [combined].
    destruct (rest (length (b :: l) - 1)%nat l 1%nat ltac:(simpl; lia) Hl) as [I _].
    assert (first : forall n, bernstein n 0 0 = 1) by (intros [| n]; unfold bernstein; rewrite Rminus_0_r, pow1; simpl; ring).
    rewrite first; lra.
  - clear weight; set (n := (length a - 1)%nat) in *; clearbody n; revert Hlength; generalize 0%nat as i; revert Ha F.
    induction a as [| b l IH]; intros Ha F i Hi; [contradiction |]; inversion F as [| b' l' Hb Hl]; subst; cbn [combined length] in *.
    destruct l as [| b2 l].
    + simpl in Hi; replace n with i by lia; unfold bernstein; rewrite Nat.sub_diag, pow1; simpl.
      pose proof (binomial_positive i i ltac:(lia)) as P; apply IZR_lt in P; nra.
    + specialize (IH ltac:(discriminate) Hl (S i) ltac:(lia)); unfold bernstein at 1.
      replace (n - i)%nat with (S (n - S i)) by (simpl in Hi; lia); rewrite Rminus_diag_eq, pow_ne_zero by (reflexivity || lia).
      rewrite Rmult_0_r, Rmult_0_l, Rplus_0_l; exact IH.
  - apply rest; [exact Hlength | exact F | lra | exact Ha].
Qed.

Section Weights.

Variable radicands : list BinInt.Z.
Hypothesis radicands_nonnegative : nonnegative radicands = true.

Definition number_positive (common : BinInt.Z) (terms : list term) : bool :=
  divides common terms && (0 <? common)%Z
  && match polynomial_of radicands common [] terms with Pc x => positive radicands x | _ => false end.

Lemma positive_number : forall common terms, number_positive common terms = true -> 0 < spelled radicands [] terms.
Proof.
  intros common terms H; unfold number_positive in H.
  apply andb_prop in H as [H P]; apply andb_prop in H as [D N]; apply Z.ltb_lt, IZR_lt in N.
  pose proof (polynomial_of_value radicands radicands_nonnegative [] common terms D) as V.
  change (variables (length (@nil R))) with (@nil polynomial) in V.
  destruct (polynomial_of radicands common [] terms) as [x | ? ? | ? ? ?]; try discriminate.
  apply (positive_value radicands radicands_nonnegative) in P.
  change (value (square_roots radicands) x = IZR common * spelled radicands [] terms) in V; nra.
Qed.

Definition weights_positive (common : BinInt.Z) (net : net_terms) : bool :=
  negb (length net =? 0)%nat && forallb (fun row => negb (length row =? 0)%nat && forallb (fun p => number_positive common (entry 3 p)) row) net.

Theorem weight_positive : forall common net real_net u v,
  weights_positive common net = true -> net_of radicands [] net = real_net ->
  0 <= u <= 1 -> 0 <= v <= 1 -> 0 < patch W real_net u v.
Proof.
  intros common net real_net u v H <- Hu Hv; unfold weights_positive in H; apply andb_prop in H as [Hnet H].
  apply negb_true_iff, Nat.eqb_neq in Hnet; rewrite forallb_forall in H.
  unfold patch, net_of; rewrite map_map; apply bezier_positive; [exact Hu | destruct net; [contradiction | discriminate] |].
  apply Forall_map; rewrite Forall_forall; intros row Irow; specialize (H _ Irow); apply andb_prop in H as [Hrow H].
  apply negb_true_iff, Nat.eqb_neq in Hrow; rewrite forallb_forall in H.
  rewrite map_map; apply bezier_positive; [exact Hv | destruct row; [contradiction | discriminate] |].
  apply Forall_map; rewrite Forall_forall; intros p Ip; apply (positive_number common), H, Ip.
Qed.

Lemma not_zero : forall common terms real,
  number_positive common terms || number_positive common (map (fun t => Term (- numerator t) (denominator t) (root t) (powers t)) terms) = true ->
  spelled radicands [] terms = real -> real <> 0.
Proof.
  intros common terms real H <-; apply orb_prop in H as [H | H]; apply positive_number in H; [lra |].
  rewrite spelled_value in * by assumption; intros E.
  assert (opposite : forall l, sum_value (square_roots radicands) [] (map (fun t => Term (- numerator t) (denominator t) (root t) (powers t)) l)
    = - sum_value (square_roots radicands) [] l).
  { induction l as [| t l IH]; simpl; [ring |]; rewrite IH; unfold term_value; simpl; rewrite opp_IZR; unfold Rdiv; ring. }
  rewrite opposite in H; lra.
Qed.

End Weights.

End Replay.

(** * 3. The certificate *)

Module Data.

Import Replay.
Local Open Scope nat_scope.

Definition radicands : list BinInt.Z := []%Z.

Definition net : net_terms :=
  [[[[Term (-1) 1 [] []]; [Term (-1) 1 [] []]; [Term 1 2 [] []]; [Term 3 2 [] []]];
    [[Term (-1) 1 [] []]; []; [Term 1 1 [] []]; [Term 1 1 [] []]];
    [[Term (-1) 1 [] []]; [Term 1 1 [] []]; [Term 1 2 [] []]; [Term 3 2 [] []]]];
   [[[]; [Term (-1) 1 [] []]; [Term 1 1 [] []]; [Term 1 1 [] []]];
    [[]; []; [Term 3 2 [] []]; [Term 1 2 [] []]];
    [[]; [Term 1 1 [] []]; [Term 1 1 [] []]; [Term 1 1 [] []]]];
   [[[Term 1 1 [] []]; [Term (-1) 1 [] []]; [Term 1 2 [] []]; [Term 3 2 [] []]];
    [[Term 1 1 [] []]; []; [Term 1 1 [] []]; [Term 1 1 [] []]];
    [[Term 1 1 [] []]; [Term 1 1 [] []]; [Term 1 2 [] []]; [Term 3 2 [] []]]]].

Definition surface : list term :=
  [Term 1 1 [] [(0, 2)]; Term 1 1 [] [(1, 2)]; Term 1 1 [] [(2, 2)]; Term (-1) 1 [] [(3, 2)]].

Definition plane_u0 : list term :=
  [Term 1 1 [] [(0, 1)]; Term 1 2 [] [(2, 1)]; Term 1 2 [] [(3, 1)]].

Definition plane_u1 : list term :=
  [Term 1 1 [] [(0, 1)]; Term (-1) 2 [] [(2, 1)]; Term (-1) 2 [] [(3, 1)]].

Definition plane_v0 : list term :=
  [Term 1 1 [] [(1, 1)]; Term 1 2 [] [(2, 1)]; Term 1 2 [] [(3, 1)]].

Definition plane_v1 : list term :=
  [Term 1 1 [] [(1, 1)]; Term (-1) 2 [] [(2, 1)]; Term (-1) 2 [] [(3, 1)]].

Lemma on_surface : identity radicands 2 net 2 1 surface (variable 0) (variable 1) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

End Data.

(** * 4. The theorem *)

(** Every point of the patch lies on the surface. *)
Theorem on_the_surface : forall u v : R, patch W net u v <> 0 -> lies_on surface net u v.
Proof.
  intros u v.
  exact (Replay.on_the_surface Data.radicands eq_refl 2 Data.net 2 1 Data.surface
           (Replay.variable 0) (Replay.variable 1) Data.on_surface [u; v] u v
           (Replay.at_variable _ 0 _) (Replay.at_variable _ 1 _) net eq_refl surface (fun _ _ _ _ => eq_refl)).
Qed.

(** On the square W is positive. *)
Theorem weight_is_positive : forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 -> 0 < patch W net u v.
Proof.
  intros u v.
  apply (Replay.weight_positive Data.radicands eq_refl 2 Data.net); [vm_compute; reflexivity | reflexivity].
Qed.

(** The edge u = 0 lies in its plane. *)
Theorem edge_u0 : forall v : R, patch W net 0 v <> 0 -> lies_on plane_u0 net 0 v.
Proof.
  intros v.
  refine (Replay.on_the_surface Data.radicands eq_refl 2 Data.net 1 2 Data.plane_u0
            (Replay.constant (Replay.Int 0)) (Replay.variable 0) _ [v] 0 v
            (Replay.at_int _ _ _) (Replay.at_variable _ 0 _) net eq_refl plane_u0 (fun _ _ _ _ => eq_refl)).
  vm_cast_no_check (eq_refl true).
Qed.

(** The edge u = 1 lies in its plane. *)
Theorem edge_u1 : forall v : R, patch W net 1 v <> 0 -> lies_on plane_u1 net 1 v.
Proof.
  intros v.
  refine (Replay.on_the_surface Data.radicands eq_refl 2 Data.net 1 2 Data.plane_u1
            (Replay.constant (Replay.Int 1)) (Replay.variable 0) _ [v] 1 v
            (Replay.at_int _ _ _) (Replay.at_variable _ 0 _) net eq_refl plane_u1 (fun _ _ _ _ => eq_refl)).
  vm_cast_no_check (eq_refl true).
Qed.

(** The edge v = 0 lies in its plane. *)
Theorem edge_v0 : forall u : R, patch W net u 0 <> 0 -> lies_on plane_v0 net u 0.
Proof.
  intros u.
  refine (Replay.on_the_surface Data.radicands eq_refl 2 Data.net 1 2 Data.plane_v0
            (Replay.variable 0) (Replay.constant (Replay.Int 0)) _ [u] u 0
            (Replay.at_variable _ 0 _) (Replay.at_int _ _ _) net eq_refl plane_v0 (fun _ _ _ _ => eq_refl)).
  vm_cast_no_check (eq_refl true).
Qed.

(** The edge v = 1 lies in its plane. *)
Theorem edge_v1 : forall u : R, patch W net u 1 <> 0 -> lies_on plane_v1 net u 1.
Proof.
  intros u.
  refine (Replay.on_the_surface Data.radicands eq_refl 2 Data.net 1 2 Data.plane_v1
            (Replay.variable 0) (Replay.constant (Replay.Int 1)) _ [u] u 1
            (Replay.at_variable _ 0 _) (Replay.at_int _ _ _) net eq_refl plane_v1 (fun _ _ _ _ => eq_refl)).
  vm_cast_no_check (eq_refl true).
Qed.

Definition theorems := (on_the_surface, weight_is_positive, edge_u0, edge_u1, edge_v0, edge_v1).

Print Assumptions theorems.
