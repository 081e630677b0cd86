(** Spherical cap over a cube face, bidegree (4,4), interior with the symmetry of the square, standard edges

    For all real values of the unknowns the patch has a point (W is not zero there)
    that is not on the surface: [misses_the_surface], at the end of this file.
    Hence it never lies on the surface: [never_on_the_surface].

    Part 1 and part 4 are to be read: what is defined, and what is proved of it. Part 2 is a checker of certificates with the proof
    that it is right; part 3 is a certificate. Coq verifies all of it:  coqc FILE.v  (written for Coq 8.16; no library but its own).
    To read it: R are the real numbers, f x y is f(x, y), [a; b] a list, /\ is and, ~ not, <> not equal, -> implies.
    The last lines print the axioms that the theorems rest on: those of Coq's real numbers.

    Written by prove-cap; statement sha256 3fa4d8c503ff6286ffaa7d61a4c9abfd1b9899c2bc8d1a18a77ea2997ebcb71f *)

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

(** The control net: rows 0 to 4 along u, in each the points 0 to 4 along v. *)
Definition net (X11 Z11 W11 Y12 Z12 W12 Z22 W22 : R) : list (list point) :=
  [[Point (-(sqrt 3 / 3)) (-(sqrt 3 / 3)) (sqrt 3 / 3) 1;
    Point (-(sqrt 3 / 6)) (-(sqrt 2 / 4) - sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6);
    Point 0 (-(sqrt 2 / 3) - sqrt 3 / 9) (sqrt 2 / 3 + sqrt 3 / 9) (1 / 3 + 2 * sqrt 6 / 9);
    Point (sqrt 3 / 6) (-(sqrt 2 / 4) - sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6);
    Point (sqrt 3 / 3) (-(sqrt 3 / 3)) (sqrt 3 / 3) 1];
   [Point (-(sqrt 2 / 4) - sqrt 3 / 6) (-(sqrt 3 / 6)) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6);
    Point X11 X11 Z11 W11;
    Point 0 Y12 Z12 W12;
    Point (-(X11)) X11 Z11 W11;
    Point (sqrt 2 / 4 + sqrt 3 / 6) (-(sqrt 3 / 6)) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6)];
   [Point (-(sqrt 2 / 3) - sqrt 3 / 9) 0 (sqrt 2 / 3 + sqrt 3 / 9) (1 / 3 + 2 * sqrt 6 / 9);
    Point Y12 0 Z12 W12;
    Point 0 0 Z22 W22;
    Point (-(Y12)) 0 Z12 W12;
    Point (sqrt 2 / 3 + sqrt 3 / 9) 0 (sqrt 2 / 3 + sqrt 3 / 9) (1 / 3 + 2 * sqrt 6 / 9)];
   [Point (-(sqrt 2 / 4) - sqrt 3 / 6) (sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6);
    Point X11 (-(X11)) Z11 W11;
    Point 0 (-(Y12)) Z12 W12;
    Point (-(X11)) (-(X11)) Z11 W11;
    Point (sqrt 2 / 4 + sqrt 3 / 6) (sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6)];
   [Point (-(sqrt 3 / 3)) (sqrt 3 / 3) (sqrt 3 / 3) 1;
    Point (-(sqrt 3 / 6)) (sqrt 2 / 4 + sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6);
    Point 0 (sqrt 2 / 3 + sqrt 3 / 9) (sqrt 2 / 3 + sqrt 3 / 9) (1 / 3 + 2 * sqrt 6 / 9);
    Point (sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (sqrt 2 / 4 + sqrt 3 / 6) (1 / 2 + sqrt 6 / 6);
    Point (sqrt 3 / 3) (sqrt 3 / 3) (sqrt 3 / 3) 1]].

(** The surface: where this is zero. *)
Definition surface (X Y Z W : R) : R := X ^ 2 + Y ^ 2 + Z ^ 2 - W ^ 2.

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

End Replay.

(** * 3. The certificate *)

Module Data.

Import Replay.
Local Open Scope nat_scope.

Definition radicands : list BinInt.Z := [2; 3]%Z.

Definition net : net_terms :=
  [[[[Term (-1) 3 [false; true] []]; [Term (-1) 3 [false; true] []]; [Term 1 3 [false; true] []]; [Term 1 1 [] []]];
    [[Term (-1) 6 [false; true] []]; [Term (-1) 4 [true] []; Term (-1) 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]];
    [[]; [Term (-1) 3 [true] []; Term (-1) 9 [false; true] []]; [Term 1 3 [true] []; Term 1 9 [false; true] []]; [Term 1 3 [] []; Term 2 9 [true; true] []]];
    [[Term 1 6 [false; true] []]; [Term (-1) 4 [true] []; Term (-1) 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]];
    [[Term 1 3 [false; true] []]; [Term (-1) 3 [false; true] []]; [Term 1 3 [false; true] []]; [Term 1 1 [] []]]];
   [[[Term (-1) 4 [true] []; Term (-1) 6 [false; true] []]; [Term (-1) 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]];
    [[Term 1 1 [] [(0, 1)]]; [Term 1 1 [] [(0, 1)]]; [Term 1 1 [] [(1, 1)]]; [Term 1 1 [] [(2, 1)]]];
    [[]; [Term 1 1 [] [(3, 1)]]; [Term 1 1 [] [(4, 1)]]; [Term 1 1 [] [(5, 1)]]];
    [[Term (-1) 1 [] [(0, 1)]]; [Term 1 1 [] [(0, 1)]]; [Term 1 1 [] [(1, 1)]]; [Term 1 1 [] [(2, 1)]]];
    [[Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term (-1) 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]]];
   [[[Term (-1) 3 [true] []; Term (-1) 9 [false; true] []]; []; [Term 1 3 [true] []; Term 1 9 [false; true] []]; [Term 1 3 [] []; Term 2 9 [true; true] []]];
    [[Term 1 1 [] [(3, 1)]]; []; [Term 1 1 [] [(4, 1)]]; [Term 1 1 [] [(5, 1)]]];
    [[]; []; [Term 1 1 [] [(6, 1)]]; [Term 1 1 [] [(7, 1)]]];
    [[Term (-1) 1 [] [(3, 1)]]; []; [Term 1 1 [] [(4, 1)]]; [Term 1 1 [] [(5, 1)]]];
    [[Term 1 3 [true] []; Term 1 9 [false; true] []]; []; [Term 1 3 [true] []; Term 1 9 [false; true] []]; [Term 1 3 [] []; Term 2 9 [true; true] []]]];
   [[[Term (-1) 4 [true] []; Term (-1) 6 [false; true] []]; [Term 1 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]];
    [[Term 1 1 [] [(0, 1)]]; [Term (-1) 1 [] [(0, 1)]]; [Term 1 1 [] [(1, 1)]]; [Term 1 1 [] [(2, 1)]]];
    [[]; [Term (-1) 1 [] [(3, 1)]]; [Term 1 1 [] [(4, 1)]]; [Term 1 1 [] [(5, 1)]]];
    [[Term (-1) 1 [] [(0, 1)]]; [Term (-1) 1 [] [(0, 1)]]; [Term 1 1 [] [(1, 1)]]; [Term 1 1 [] [(2, 1)]]];
    [[Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]]];
   [[[Term (-1) 3 [false; true] []]; [Term 1 3 [false; true] []]; [Term 1 3 [false; true] []]; [Term 1 1 [] []]];
    [[Term (-1) 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]];
    [[]; [Term 1 3 [true] []; Term 1 9 [false; true] []]; [Term 1 3 [true] []; Term 1 9 [false; true] []]; [Term 1 3 [] []; Term 2 9 [true; true] []]];
    [[Term 1 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 4 [true] []; Term 1 6 [false; true] []]; [Term 1 2 [] []; Term 1 6 [true; true] []]];
    [[Term 1 3 [false; true] []]; [Term 1 3 [false; true] []]; [Term 1 3 [false; true] []]; [Term 1 1 [] []]]]].

Definition surface : list term :=
  [Term 1 1 [] [(0, 2)]; Term 1 1 [] [(1, 2)]; Term 1 1 [] [(2, 2)]; Term (-1) 1 [] [(3, 2)]].

Definition assumptions : list (list term * nat) :=
  [].

Definition certificate : list derivation :=
  [(* 1: ... *)
   Derive [(c 2 2, [Term 4 1 [] []]);
     (c 2 4, [Term (-4) 1 [] []]);
     (c 4 4, [Term 1 1 [] []])]
     432 [Term (-13824) 1 [] [(3, 2)]; Term 3888 1 [] [(6, 2)]; Term (-3888) 1 [] [(7, 2)]; Term (-1536) 1 [false; true] [(3, 1)]; Term (-1728) 1 [true] [(6, 1)]; Term (-288) 1 [false; true] [(6, 1)]; Term 864 1 [] [(7, 1)]; Term 1152 1 [true; true] [(7, 1)]; Term (-288) 1 [] []; Term (-64) 1 [true; true] []];
   (* 2: 12 * sqrt 2 * X11 - 12 * sqrt 2 * Z11 + 18 * W12 + 3 + sqrt 6 = 0 *)
   Derive [(c 1 1, [Term 6 1 [] []; Term 3 1 [true; true] []]);
     (c 1 3, [Term (-6) 1 [] []; Term (-1) 1 [true; true] []]);
     (c 1 4, [Term 3 1 [] []; Term 1 1 [true; true] []])]
     6912 [Term 12 1 [true] [(0, 1)]; Term (-12) 1 [true] [(1, 1)]; Term 18 1 [] [(5, 1)]; Term 3 1 [] []; Term 1 1 [true; true] []];
   (* 3: 16 * sqrt 3 * X11 - 8 * sqrt 3 * Z11 - 9 * sqrt 2 * Y12 + 9 * sqrt 2 * Z12 + 5 / 2 + sqrt 6 = 0 *)
   Derive [(c 1 1, [Term 5 1 [] []; Term 2 1 [true; true] []]);
     (c 1 3, [Term (-3) 1 [] []; Term (-2) 1 [true; true] []]);
     (c 1 4, [Term 3 1 [] []; Term 1 1 [true; true] []])]
     3456 [Term 32 1 [false; true] [(0, 1)]; Term (-16) 1 [false; true] [(1, 1)]; Term (-18) 1 [true] [(3, 1)]; Term 18 1 [true] [(4, 1)]; Term 5 1 [] []; Term 2 1 [true; true] []];
   (* 4: ... *)
   Derive [(c 1 1, [Term 16 1 [false; true] [(0, 1)]; Term (-8) 1 [false; true] [(1, 1)]; Term (-24) 1 [] [(2, 1)]; Term 1 1 [] []]);
     (c 2 2, [Term 3 1 [] []]);
     (step 2, [Term 41472 1 [] []; Term 13824 1 [true; true] []]);
     (step 3, [Term (-20736) 1 [] []; Term (-6912) 1 [true; true] []])]
     1728 [Term 384 1 [] [(0, 2)]; Term 768 1 [] [(0, 1); (1, 1)]; Term 384 1 [] [(1, 2)]; Term (-96) 1 [true] [(0, 1)]; Term (-224) 1 [false; true] [(0, 1)]; Term (-96) 1 [true] [(1, 1)]; Term 16 1 [false; true] [(1, 1)]; Term 216 1 [true] [(3, 1)]; Term 54 1 [false; true] [(6, 1)]; Term (-162) 1 [] [(7, 1)]; Term (-13) 1 [] []; Term (-8) 1 [true; true] []];
   (* 5: ... *)
   Derive [(c 2 3, [Term 2 1 [] []]);
     (c 3 4, [Term (-1) 1 [] []]);
     (step 2, [Term (-124416) 1 [] [(7, 1)]; Term 13824 1 [] []; Term 4608 1 [true; true] []]);
     (step 3, [Term 62208 1 [true] [(6, 1)]; Term (-6912) 1 [] []; Term (-2304) 1 [true; true] []])]
     4608 [Term 864 1 [] [(0, 1); (3, 1)]; Term 432 1 [true; true] [(0, 1); (6, 1)]; Term (-324) 1 [true] [(0, 1); (7, 1)]; Term (-216) 1 [true; true] [(1, 1); (6, 1)]; Term 324 1 [true] [(1, 1); (7, 1)]; Term (-486) 1 [] [(3, 1); (6, 1)]; Term (-12) 1 [true] [(0, 1)]; Term (-48) 1 [false; true] [(0, 1)]; Term (-12) 1 [true] [(1, 1)]; Term 18 1 [false; true] [(3, 1)]; Term 108 1 [true] [(6, 1)]; Term 81 1 [false; true] [(6, 1)]; Term (-162) 1 [] [(7, 1)]; Term (-54) 1 [true; true] [(7, 1)]; Term 9 1 [] []; Term 2 1 [true; true] []];
   (* 6: ... *)
   Derive [(c 1 1, [Term 16 1 [false; true] [(0, 1)]; Term (-8) 1 [false; true] [(1, 1)]; Term (-24) 1 [] [(2, 1)]; Term 1 1 [] []]);
     (c 2 2, [Term (-3) 1 [] []]);
     (c 2 4, [Term 3 1 [] []]);
     (step 1, [Term 324 1 [] []]);
     (step 2, [Term (-82944) 1 [true] [(0, 1)]; Term 82944 1 [true] [(1, 1)]; Term 124416 1 [] [(5, 1)]; Term (-20736) 1 [] []; Term (-6912) 1 [true; true] []]);
     (step 3, [Term 110592 1 [false; true] [(0, 1)]; Term (-55296) 1 [false; true] [(1, 1)]; Term (-62208) 1 [true] [(3, 1)]; Term (-62208) 1 [true] [(4, 1)]; Term 17280 1 [] []; Term 6912 1 [true; true] []])]
     1728 [Term 3072 1 [] [(0, 2)]; Term (-3072) 1 [] [(0, 1); (1, 1)]; Term (-2304) 1 [true; true] [(0, 1); (3, 1)]; Term 768 1 [] [(1, 2)]; Term 1152 1 [true; true] [(1, 1); (3, 1)]; Term 729 1 [] [(6, 2)]; Term (-729) 1 [] [(7, 2)]; Term 480 1 [true] [(0, 1)]; Term 416 1 [false; true] [(0, 1)]; Term (-96) 1 [true] [(1, 1)]; Term (-112) 1 [false; true] [(1, 1)]; Term (-360) 1 [true] [(3, 1)]; Term (-288) 1 [false; true] [(3, 1)]; Term (-35) 1 [] []; Term (-8) 1 [true; true] []];
   (* 7: ... *)
   Derive [(c 1 1, [Term (-108) 1 [] [(7, 1)]; Term (-15) 1 [] []; Term (-8) 1 [true; true] []]);
     (c 3 3, [Term 3 1 [] []]);
     (step 2, [Term (-165888) 1 [true] [(0, 1)]; Term 165888 1 [true] [(1, 1)]; Term 248832 1 [] [(5, 1)]]);
     (step 3, [Term 221184 1 [false; true] [(0, 1)]; Term (-110592) 1 [false; true] [(1, 1)]; Term (-124416) 1 [true] [(3, 1)]; Term (-124416) 1 [true] [(4, 1)]; Term 13824 1 [] []; Term 6912 1 [true; true] []])]
     6912 [Term 2496 1 [] [(0, 2)]; Term (-1920) 1 [] [(0, 1); (1, 1)]; Term (-1152) 1 [true; true] [(0, 1); (3, 1)]; Term 432 1 [false; true] [(0, 1); (7, 1)]; Term 192 1 [] [(1, 2)]; Term 576 1 [true; true] [(1, 1); (3, 1)]; Term 648 1 [] [(1, 1); (6, 1)]; Term (-216) 1 [false; true] [(1, 1); (7, 1)]; Term 648 1 [] [(3, 2)]; Term 384 1 [true] [(0, 1)]; Term 272 1 [false; true] [(0, 1)]; Term (-48) 1 [true] [(1, 1)]; Term (-64) 1 [false; true] [(1, 1)]; Term (-72) 1 [true] [(3, 1)]; Term (-72) 1 [false; true] [(3, 1)]; Term 27 1 [] [(7, 1)]; Term 19 1 [] []; Term 8 1 [true; true] []];
   (* 8: ... *)
   Derive [(c 1 1, [Term (-144) 1 [] [(5, 1)]; Term (-12) 1 [] []; Term (-4) 1 [true; true] []]);
     (c 3 4, [Term 3 1 [] []]);
     (step 2, [Term (-221184) 1 [false; true] [(0, 1)]; Term 110592 1 [false; true] [(1, 1)]; Term 373248 1 [] [(7, 1)]; Term 6912 1 [] []; Term 13824 1 [true; true] []]);
     (step 3, [Term (-165888) 1 [true] [(1, 1)]; Term (-186624) 1 [true] [(6, 1)]; Term (-20736) 1 [] []; Term (-3456) 1 [true; true] []])]
     6912 [Term (-384) 1 [true; true] [(0, 2)]; Term (-192) 1 [true; true] [(0, 1); (1, 1)]; Term (-864) 1 [] [(0, 1); (3, 1)]; Term (-864) 1 [true; true] [(0, 1); (6, 1)]; Term 648 1 [true] [(0, 1); (7, 1)]; Term 192 1 [true; true] [(1, 2)]; Term 864 1 [] [(1, 1); (3, 1)]; Term 432 1 [true; true] [(1, 1); (6, 1)]; Term (-648) 1 [true] [(1, 1); (7, 1)]; Term 972 1 [] [(3, 1); (6, 1)]; Term (-48) 1 [true] [(0, 1)]; Term (-48) 1 [false; true] [(0, 1)]; Term (-48) 1 [true] [(1, 1)]; Term (-48) 1 [false; true] [(1, 1)]; Term 108 1 [true] [(3, 1)]; Term 36 1 [false; true] [(3, 1)]; Term (-135) 1 [true] [(6, 1)]; Term (-108) 1 [false; true] [(6, 1)]; Term 162 1 [] [(7, 1)]; Term 54 1 [true; true] [(7, 1)]; Term (-30) 1 [] []; Term (-11) 1 [true; true] []];
   (* 9: ... *)
   Derive [(step 1, [Term (-11232) 1 [] [(0, 1)]; Term (-4752) 1 [true; true] [(0, 1)]; Term (-11232) 1 [] [(1, 1)]; Term (-4752) 1 [true; true] [(1, 1)]; Term 135 1 [true] []; Term 3195 1 [false; true] []]);
     (step 4, [Term (-479232) 1 [] [(0, 1)]; Term (-87552) 1 [true; true] [(0, 1)]; Term 239616 1 [] [(1, 1)]; Term 43776 1 [true; true] [(1, 1)]; Term 196992 1 [] [(3, 1)]; Term 179712 1 [true; true] [(3, 1)]; Term (-95232) 1 [true] []; Term (-71904) 1 [false; true] []]);
     (step 5, [Term 230400 1 [] [(0, 1)]; Term (-377856) 1 [] [(1, 1)]; Term (-239616) 1 [true; true] [(1, 1)]; Term (-359424) 1 [] [(3, 1)]; Term (-152064) 1 [true; true] [(3, 1)]; Term 163200 1 [true] []; Term 142400 1 [false; true] []]);
     (step 6, [Term 59904 1 [] [(0, 1)]; Term 25344 1 [true; true] [(0, 1)]; Term 59904 1 [] [(1, 1)]; Term 25344 1 [true; true] [(1, 1)]; Term (-3696) 1 [true] []; Term (-16512) 1 [false; true] []]);
     (step 7, [Term (-7488) 1 [true] []; Term (-6336) 1 [false; true] []]);
     (step 8, [Term 115200 1 [] [(0, 1)]; Term (-188928) 1 [] [(1, 1)]; Term (-119808) 1 [true; true] [(1, 1)]; Term (-179712) 1 [] [(3, 1)]; Term (-76032) 1 [true; true] [(3, 1)]; Term 81600 1 [true] []; Term 78400 1 [false; true] []])]
     48 [Term 171072 1 [] [(0, 1); (7, 1)]; Term (-159408) 1 [true; true] [(0, 1); (7, 1)]; Term 7776 1 [true] [(1, 1); (6, 1)]; Term (-23328) 1 [false; true] [(1, 1); (6, 1)]; Term (-163296) 1 [] [(1, 1); (7, 1)]; Term 50544 1 [true; true] [(1, 1); (7, 1)]; Term 46656 1 [true] [(3, 1); (6, 1)]; Term (-91368) 1 [false; true] [(3, 1); (6, 1)]; Term 454896 1 [] [(3, 1); (7, 1)]; Term (-147744) 1 [true; true] [(3, 1); (7, 1)]; Term (-45198) 1 [true] [(6, 2)]; Term 8019 1 [false; true] [(6, 2)]; Term 45198 1 [true] [(7, 2)]; Term (-8019) 1 [false; true] [(7, 2)]; Term (-25440) 1 [] [(0, 1)]; Term 40960 1 [true; true] [(0, 1)]; Term 79488 1 [] [(1, 1)]; Term (-4832) 1 [true; true] [(1, 1)]; Term (-177984) 1 [] [(3, 1)]; Term 101376 1 [true; true] [(3, 1)]; Term 157194 1 [] [(6, 1)]; Term (-31266) 1 [true; true] [(6, 1)]; Term 58266 1 [true] [(7, 1)]; Term (-96498) 1 [false; true] [(7, 1)]; Term (-3527) 1 [true] []; Term (-6144) 1 [false; true] []];
   (* 10: ... *)
   Derive [(step 1, [Term 18 1 [] [(0, 1)]; Term 18 1 [] [(1, 1)]]);
     (step 4, [Term 768 1 [] [(0, 1)]; Term (-384) 1 [] [(1, 1)]; Term (-288) 1 [true; true] [(3, 1)]; Term 138 1 [true] []; Term 85 1 [false; true] []]);
     (step 5, [Term 384 1 [true; true] [(1, 1)]; Term 576 1 [] [(3, 1)]; Term (-280) 1 [true] []; Term (-240) 1 [false; true] []]);
     (step 6, [Term (-96) 1 [] [(0, 1)]; Term (-96) 1 [] [(1, 1)]; Term (-144) 1 [true] []; Term (-44) 1 [false; true] []]);
     (step 7, [Term 204 1 [true] []; Term 126 1 [false; true] []]);
     (step 8, [Term 192 1 [true; true] [(1, 1)]; Term 288 1 [] [(3, 1)]])]
     1 [Term (-342144) 1 [true] [(0, 1); (6, 1)]; Term (-205632) 1 [false; true] [(0, 1); (6, 1)]; Term 235872 1 [] [(0, 1); (7, 1)]; Term 186624 1 [true; true] [(0, 1); (7, 1)]; Term 24192 1 [true] [(1, 1); (3, 1)]; Term (-13824) 1 [false; true] [(1, 1); (3, 1)]; Term 287712 1 [true] [(1, 1); (6, 1)]; Term 207792 1 [false; true] [(1, 1); (6, 1)]; Term (-247536) 1 [] [(1, 1); (7, 1)]; Term (-132192) 1 [true; true] [(1, 1); (7, 1)]; Term 163296 1 [true] [(3, 2)]; Term (-22032) 1 [false; true] [(3, 2)]; Term 112752 1 [true] [(3, 1); (6, 1)]; Term 132192 1 [false; true] [(3, 1); (6, 1)]; Term (-46656) 1 [] [(3, 1); (7, 1)]; Term 31104 1 [true; true] [(3, 1); (7, 1)]; Term (-104976) 1 [true] [(6, 2)]; Term (-32076) 1 [false; true] [(6, 2)]; Term 104976 1 [true] [(7, 2)]; Term 32076 1 [false; true] [(7, 2)]; Term 12192 1 [] [(0, 1)]; Term (-6432) 1 [true; true] [(0, 1)]; Term (-21936) 1 [] [(1, 1)]; Term (-1440) 1 [true; true] [(1, 1)]; Term 142128 1 [] [(3, 1)]; Term 48600 1 [true; true] [(3, 1)]; Term (-105030) 1 [] [(6, 1)]; Term (-41148) 1 [true; true] [(6, 1)]; Term 67392 1 [true] [(7, 1)]; Term 58752 1 [false; true] [(7, 1)]; Term 5202 1 [true] []; Term 2909 1 [false; true] []];
   (* 11: ... *)
   Derive [(step 1, [Term 26526118054629600 1 [true] [(0, 1)]; Term 21692929619278800 1 [false; true] [(0, 1)]; Term 15605887499119800 1 [true] [(1, 1)]; Term 12979459699754400 1 [false; true] [(1, 1)]; Term (-3664613551562550) 1 [true] [(3, 1)]; Term (-2862487298914650) 1 [false; true] [(3, 1)]; Term 3637154731495275 1 [true] [(6, 1)]; Term 3000913594973325 1 [false; true] [(6, 1)]; Term (-256846029149475) 1 [] [(7, 1)]; Term (-111367175098275) 1 [true; true] [(7, 1)]; Term (-4702030335637875) 1 [] []; Term (-1916732982387750) 1 [true; true] []]);
     (step 4, [Term 427882210680825600 1 [true] [(0, 1)]; Term 348743696964556800 1 [false; true] [(0, 1)]; Term (-202879080256627200) 1 [true] [(1, 1)]; Term (-165233342128761600) 1 [false; true] [(1, 1)]; Term (-485896230367203600) 1 [true] [(3, 1)]; Term (-396658214764060800) 1 [false; true] [(3, 1)]; Term (-48805918317288000) 1 [true] [(6, 1)]; Term (-40460846097744000) 1 [false; true] [(6, 1)]; Term (-24878854343584800) 1 [] [(7, 1)]; Term (-10027833181207200) 1 [true; true] [(7, 1)]; Term 242330834946282000 1 [] []; Term 98878024170818000 1 [true; true] []]);
     (step 5, [Term 109979569710451200 1 [true] [(0, 1)]; Term 93221927454873600 1 [false; true] [(0, 1)]; Term 603456430444108800 1 [true] [(1, 1)]; Term 490361561028326400 1 [false; true] [(1, 1)]; Term 519224569424457600 1 [true] [(3, 1)]; Term 427236264692092800 1 [false; true] [(3, 1)]; Term 139332226539945600 1 [true] [(6, 1)]; Term 114207851196316800 1 [false; true] [(6, 1)]; Term 36118245733660800 1 [] [(7, 1)]; Term 13591949332291200 1 [true; true] [(7, 1)]; Term (-430462130164267200) 1 [] []; Term (-175556568287760800) 1 [true; true] []]);
     (step 6, [Term (-141472629624691200) 1 [true] [(0, 1)]; Term (-115695624636153600) 1 [false; true] [(0, 1)]; Term (-81577591449254400) 1 [true] [(1, 1)]; Term (-67636323250963200) 1 [false; true] [(1, 1)]; Term 18369311058576000 1 [true] [(3, 1)]; Term 15772651899888000 1 [false; true] [(3, 1)]; Term (-19398158567974800) 1 [true] [(6, 1)]; Term (-16004872506524400) 1 [false; true] [(6, 1)]; Term 1369845488797200 1 [] [(7, 1)]; Term 593958267190800 1 [true; true] [(7, 1)]; Term 26697120458521200 1 [] []; Term 10882672962156800 1 [true; true] []]);
     (step 7, [Term 104143138510579200 1 [true] [(0, 1)]; Term 84613326799257600 1 [false; true] [(0, 1)]; Term 14300581247424000 1 [true] [(1, 1)]; Term 12524374721472000 1 [false; true] [(1, 1)]; Term (-77433339442485600) 1 [true] [(3, 1)]; Term (-64747982253196800) 1 [false; true] [(3, 1)]; Term 26880711664682400 1 [] []; Term 10935553032213600 1 [true; true] []]);
     (step 8, [Term (-13417337964748800) 1 [true] [(0, 1)]; Term (-8989475332646400) 1 [false; true] [(0, 1)]; Term 294243801269952000 1 [true] [(1, 1)]; Term 239255981687616000 1 [false; true] [(1, 1)]; Term 305724748247001600 1 [true] [(3, 1)]; Term 252128632083964800 1 [false; true] [(3, 1)]; Term 69666113269972800 1 [true] [(6, 1)]; Term 57103925598158400 1 [false; true] [(6, 1)]; Term 18059122866830400 1 [] [(7, 1)]; Term 6795974666145600 1 [true; true] [(7, 1)]; Term (-233123320656446400) 1 [] []; Term (-95053244402449600) 1 [true; true] []]);
     (step 9, [Term 35147918032128 1 [] [(1, 1)]; Term 15920071876992 1 [true; true] [(1, 1)]; Term (-43416366592608) 1 [] [(3, 1)]; Term (-16736216121312) 1 [true; true] [(3, 1)]]);
     (step 10, [Term 7304735204400 1 [true; true] [(3, 1)]])]
     466800 [Term 7934378663664 1 [true] [(0, 1); (7, 1)]; Term 6437623664592 1 [false; true] [(0, 1); (7, 1)]; Term 4425159961584 1 [true] [(1, 1); (7, 1)]; Term 3646272244752 1 [false; true] [(1, 1); (7, 1)]; Term 3781657783044 1 [true] [(3, 1); (7, 1)]; Term 3001118629032 1 [false; true] [(3, 1); (7, 1)]; Term 5061590817120 1 [true] [(6, 1); (7, 1)]; Term 4164982315560 1 [false; true] [(6, 1); (7, 1)]; Term (-7004051082612) 1 [] [(7, 2)]; Term (-2838367982268) 1 [true; true] [(7, 2)]; Term (-1061699055168) 1 [true] [(0, 1)]; Term (-867067399104) 1 [false; true] [(0, 1)]; Term (-4677623491584) 1 [true] [(1, 1)]; Term (-3819825394752) 1 [false; true] [(1, 1)]; Term (-7270415880858) 1 [true] [(3, 1)]; Term (-5927091149124) 1 [false; true] [(3, 1)]; Term (-4438974034737) 1 [true] [(6, 1)]; Term (-3630339566811) 1 [false; true] [(6, 1)]; Term 5467091259609 1 [] [(7, 1)]; Term 2228469697251 1 [true; true] [(7, 1)]; Term 2268664300914 1 [] []; Term 926005172621 1 [true; true] []];
   (* 12: ... *)
   Derive [(step 1, [Term 94514762963808 1 [true] [(0, 1)]; Term 69976420632576 1 [false; true] [(0, 1)]; Term 63327842263296 1 [true] [(1, 1)]; Term 35629231956912 1 [false; true] [(1, 1)]; Term (-12835023779700) 1 [true] [(3, 1)]; Term (-9102591988200) 1 [false; true] [(3, 1)]; Term 11175482709054 1 [true] [(6, 1)]; Term 11298943226088 1 [false; true] [(6, 1)]; Term (-4244861849040) 1 [] [(7, 1)]; Term 935989871310 1 [true; true] [(7, 1)]; Term (-20644181594532) 1 [] []; Term (-4566930976527) 1 [true; true] []]);
     (step 4, [Term 1182057392200704 1 [true] [(0, 1)]; Term 1401966370111488 1 [false; true] [(0, 1)]; Term (-551228050245120) 1 [true] [(1, 1)]; Term (-671634837450240) 1 [false; true] [(1, 1)]; Term (-1856068382337408) 1 [true] [(3, 1)]; Term (-1175119859218176) 1 [false; true] [(3, 1)]; Term (-181383770458368) 1 [true] [(6, 1)]; Term (-125224971895296) 1 [false; true] [(6, 1)]; Term (-61916040085248) 1 [] [(7, 1)]; Term (-43821187446528) 1 [true; true] [(7, 1)]; Term 807386029371648 1 [] []; Term 341439903584128 1 [true; true] []]);
     (step 5, [Term 810068027983872 1 [true] [(0, 1)]; Term (-34145887113216) 1 [false; true] [(0, 1)]; Term 2084187136702464 1 [true] [(1, 1)]; Term 1633856487799808 1 [false; true] [(1, 1)]; Term 2014863968261376 1 [true] [(3, 1)]; Term 1233498513411072 1 [false; true] [(3, 1)]; Term 423463289071104 1 [true] [(6, 1)]; Term 433084480524288 1 [false; true] [(6, 1)]; Term (-53626799188224) 1 [] [(7, 1)]; Term 117053070299136 1 [true; true] [(7, 1)]; Term (-1482504499094656) 1 [] []; Term (-586036187423616) 1 [true; true] []]);
     (step 6, [Term (-504078735806976) 1 [true] [(0, 1)]; Term (-373207576707072) 1 [false; true] [(0, 1)]; Term (-322035872647680) 1 [true] [(1, 1)]; Term (-192810293237760) 1 [false; true] [(1, 1)]; Term 57237097409280 1 [true] [(3, 1)]; Term 46207372901760 1 [false; true] [(3, 1)]; Term (-59602574448288) 1 [true] [(6, 1)]; Term (-60261030539136) 1 [false; true] [(6, 1)]; Term 22639263194880 1 [] [(7, 1)]; Term (-4991945980320) 1 [true; true] [(7, 1)]; Term 113584241236224 1 [] []; Term 27431310924864 1 [true; true] []]);
     (step 7, [Term 341245446580224 1 [true] [(0, 1)]; Term 297790673891328 1 [false; true] [(0, 1)]; Term 68181151841280 1 [true] [(1, 1)]; Term 27194748687360 1 [false; true] [(1, 1)]; Term (-273813840633600) 1 [true] [(3, 1)]; Term (-194188629081600) 1 [false; true] [(3, 1)]; Term 92857823302656 1 [] []; Term 36504129503616 1 [true; true] []]);
     (step 8, [Term 175972568374272 1 [true] [(0, 1)]; Term (-210825697161216) 1 [false; true] [(0, 1)]; Term 1043658049582080 1 [true] [(1, 1)]; Term 774139479746560 1 [false; true] [(1, 1)]; Term 1165657378887936 1 [true] [(3, 1)]; Term 762124510881792 1 [false; true] [(3, 1)]; Term 211731644535552 1 [true] [(6, 1)]; Term 216542240262144 1 [false; true] [(6, 1)]; Term (-26813399594112) 1 [] [(7, 1)]; Term 58526535149568 1 [true; true] [(7, 1)]; Term (-810781211438144) 1 [] []; Term (-314236245240384) 1 [true; true] []]);
     (step 9, [Term 253429345536 1 [] [(1, 1)]; Term (-200415271680) 1 [] [(3, 1)]; Term (-36648002880) 1 [true; true] [(3, 1)]])]
     16 [Term 1800272651467968 1 [true] [(0, 1); (7, 1)]; Term (-187706953183104) 1 [false; true] [(0, 1); (7, 1)]; Term (-364784627722176) 1 [true] [(1, 1); (7, 1)]; Term 1016869333321728 1 [false; true] [(1, 1); (7, 1)]; Term 1497618478127520 1 [true] [(3, 1); (7, 1)]; Term (-621467959671360) 1 [false; true] [(3, 1); (7, 1)]; Term 202968907626564 1 [] [(6, 2)]; Term (-82700514124821) 1 [true; true] [(6, 2)]; Term 965335832131896 1 [true] [(6, 1); (7, 1)]; Term 32989512034512 1 [false; true] [(6, 1); (7, 1)]; Term (-270297539321652) 1 [] [(7, 2)]; Term (-453557898661347) 1 [true; true] [(7, 2)]; Term (-442867767191232) 1 [true] [(0, 1)]; Term 188635054740096 1 [false; true] [(0, 1)]; Term (-242870399556432) 1 [true] [(1, 1)]; Term (-558300322197504) 1 [false; true] [(1, 1)]; Term (-1579480749900720) 1 [true] [(3, 1)]; Term 114696282875760 1 [false; true] [(3, 1)]; Term 6412898506176 1 [true] [(6, 1)]; Term (-724081602517128) 1 [false; true] [(6, 1)]; Term 1267005604113792 1 [] [(7, 1)]; Term (-75302566594488) 1 [true; true] [(7, 1)]; Term 232905707479944 1 [] []; Term 88294624655134 1 [true; true] []];
   (* 13: ... *)
   Derive [(step 1, [Term (Replay.long [1; 563576756885516033; 340909118773324596; 159748738605867600]%Z) 1 [] [(0, 1)]; Term (- Replay.long [892892467770989100; 090698572537637832; 253347662443826400]%Z) 1 [true; true] [(0, 1)]; Term (- Replay.long [42919097557139433; 411607968537737591; 125990212320586000]%Z) 1 [] [(1, 1)]; Term (Replay.long [27735812453837170; 274790573482678206; 363138946829099000]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [44; 124028137159872644; 805994885695743605; 214923903028861380]%Z) 1 [] [(3, 1)]; Term (- Replay.long [18; 096598456256760544; 198478579129009553; 289177860272592570]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [6; 548821909733740152; 909570985321972839; 827028621450470790]%Z) 1 [] [(6, 1)]; Term (Replay.long [2; 466233388804801680; 804540428724645717; 069879648285597685]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [10; 482470912985885422; 323043896772742969; 187943736364451640]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [8; 481147978097185428; 665061373366685011; 524435958967466670]%Z) 1 [false; true] [(7, 1)]; Term (Replay.long [185936000772989434; 769729875263524243; 193411949387366125]%Z) 1 [true] []; Term (- Replay.long [178972288341786257; 606779283902061112; 215716660580853375]%Z) 1 [false; true] []]);
     (step 4, [Term (Replay.long [92; 695082818789438838; 499951211341956802; 092491298037043200]%Z) 1 [] [(0, 1)]; Term (- Replay.long [36; 239557041265126725; 083945396701360897; 442084278596684800]%Z) 1 [true; true] [(0, 1)]; Term (- Replay.long [41; 337610994872764519; 928187826113998250; 159817015075244800]%Z) 1 [] [(1, 1)]; Term (Replay.long [15; 758082402962787150; 626509272048771918; 738900131080627200]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [15; 472425279567579386; 791385079167936517; 085887582160387200]%Z) 1 [] [(3, 1)]; Term (- Replay.long [6; 576150975976926677; 603728128596922675; 258493842272440800]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [28; 296890234905394324; 741961498337359918; 862987365792262800]%Z) 1 [] [(6, 1)]; Term (Replay.long [12; 165583961335357037; 568507459273117589; 866672361648579200]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [51; 164382806061369320; 511989494934681226; 326984886002054400]%Z) 1 [true] [(7, 1)]; Term (Replay.long [42; 609719656047242079; 148002981848698950; 550242621973123200]%Z) 1 [false; true] [(7, 1)]; Term (- Replay.long [798767473905031794; 175557215904845222; 226374519290692800]%Z) 1 [true] []; Term (Replay.long [995424491979894292; 072356333786039025; 298350374466208400]%Z) 1 [false; true] []]);
     (step 5, [Term (- Replay.long [348; 064509040289144060; 535413525640427887; 178858236272563200]%Z) 1 [] [(0, 1)]; Term (Replay.long [134; 379439187749309846; 469909253259480094; 418733774710924800]%Z) 1 [true; true] [(0, 1)]; Term (Replay.long [182; 005568293260001246; 655013733965463686; 889584129974604800]%Z) 1 [] [(1, 1)]; Term (- Replay.long [72; 450201257052078014; 692969988260157886; 798131866779507200]%Z) 1 [true; true] [(1, 1)]; Term (- Replay.long [359; 515221276121902012; 527402054988337232; 695373028291264000]%Z) 1 [] [(3, 1)]; Term (Replay.long [151; 376171279009666848; 884745520607512852; 920778022986656000]%Z) 1 [true; true] [(3, 1)]; Term (Replay.long [292; 067221822443786084; 091345574787189398; 919969047666659200]%Z) 1 [] [(6, 1)]; Term (- Replay.long [120; 664051508329942677; 162225945229296760; 035342114476788800]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [268; 130876410849550768; 853644201355972572; 758961229828576000]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [218; 185108686011416964; 614272604622371155; 471846291387888000]%Z) 1 [false; true] [(7, 1)]; Term (Replay.long [5; 138308390711998185; 394077842994521949; 145430563274836800]%Z) 1 [true] []; Term (- Replay.long [5; 263159954324622317; 017266114794645566; 569702454430070400]%Z) 1 [false; true] []]);
     (step 6, [Term (- Replay.long [15; 416149730843080489; 868184022292664923; 327743975829472000]%Z) 1 [] [(0, 1)]; Term (Replay.long [7; 610183913682370139; 068596308745928204; 827206645402688000]%Z) 1 [true; true] [(0, 1)]; Term (Replay.long [17; 176421344390649989; 401219095735596027; 761067570626796800]%Z) 1 [] [(1, 1)]; Term (- Replay.long [7; 094822464650184694; 478367735835295192; 631431379605875200]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [101; 055566221805366671; 928385722334056734; 233484208497843200]%Z) 1 [] [(3, 1)]; Term (- Replay.long [35; 871470361463186223; 094245894655121524; 378844818203884800]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [36; 270520038702626671; 771870999659090258; 467299260163096800]%Z) 1 [] [(6, 1)]; Term (Replay.long [18; 675891039780434462; 589666401048000854; 795579085281375200]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [25; 565788464120233288; 086178803856521030; 272017619907874400]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [20; 884193459114520874; 831500108219346011; 193063125041383200]%Z) 1 [false; true] [(7, 1)]; Term (- Replay.long [1; 330036179017337933; 698567943267945575; 054983701840374000]%Z) 1 [true] []; Term (Replay.long [1; 250399983256728805; 140744303822670950; 311151144941282000]%Z) 1 [false; true] []]);
     (step 7, [Term (Replay.long [52; 632292733321550076; 556554236256181554; 634526082229376000]%Z) 1 [] [(0, 1)]; Term (- Replay.long [24; 151790849011659681; 208817749788857517; 387206057879424000]%Z) 1 [true; true] [(0, 1)]; Term (Replay.long [3; 743436120470954357; 652449559213790128; 001308762544972800]%Z) 1 [] [(1, 1)]; Term (- Replay.long [2; 094281281512827430; 888371682917022421; 199249020366579200]%Z) 1 [true; true] [(1, 1)]; Term (- Replay.long [84; 890377376257190618; 032031815616917287; 604592379023385600]%Z) 1 [] [(3, 1)]; Term (Replay.long [27; 743646335120875626; 596130390729575940; 468509257115438400]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [28; 687318496639916172; 875323415313420296; 119143775908284000]%Z) 1 [] [(6, 1)]; Term (Replay.long [6; 579463647501946364; 358564573326874911; 065472270297856000]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [77; 101272746703503134; 085194346706481316; 224931919765408000]%Z) 1 [true] [(7, 1)]; Term (Replay.long [62; 866167238266874918; 677689380899902734; 106430254401344000]%Z) 1 [false; true] [(7, 1)]; Term (- Replay.long [895521837384835417; 788754872862331079; 461276969510582400]%Z) 1 [true] []; Term (Replay.long [647870780887765518; 701972174996063483; 339512969185127200]%Z) 1 [false; true] []]);
     (step 8, [Term (- Replay.long [132; 344726250381953540; 392490300361509121; 841270491591436800]%Z) 1 [] [(0, 1)]; Term (Replay.long [51; 912631289772478402; 862013594777636253; 432493170982035200]%Z) 1 [true; true] [(0, 1)]; Term (- Replay.long [1; 042593665812008092; 451175917839340645; 752825723371174400]%Z) 1 [] [(1, 1)]; Term (Replay.long [1; 704350081951995787; 433174951678637043; 545675830849721600]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [6; 936125266144978568; 174358910475942261; 037984750025536000]%Z) 1 [] [(3, 1)]; Term (- Replay.long [8; 745732463217975945; 003676803200186543; 549231971951424000]%Z) 1 [true; true] [(3, 1)]; Term (Replay.long [110; 542287381375592504; 397271353749725501; 223517891109744000]%Z) 1 [] [(6, 1)]; Term (- Replay.long [49; 781321444551079966; 261971294190652115; 898003469909936000]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [145; 908707665253830065; 884215312615326288; 832213662499262400]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [119; 653646035620735369; 930551480937657091; 364901389420947200]%Z) 1 [false; true] [(7, 1)]; Term (Replay.long [4; 616984756835696902; 149230738477493776; 042187909319834400]%Z) 1 [true] []; Term (- Replay.long [4; 227088912235606158; 517414802846947082; 062758969697483200]%Z) 1 [false; true] []]);
     (step 9, [Term (Replay.long [13339483533434426; 488982617424274390; 906981734664489600]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [9023122426108537; 928144141656071277; 623809012260518400]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [173549366568765486; 320745067691921868; 983968717096367424]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [139058867977914871; 427835641425561482; 059335724220363072]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [44130611073627547; 746096091540265552; 170592485838628912]%Z) 1 [true] [(6, 1)]; Term (Replay.long [36102588548066805; 308967696341274108; 410835600538779936]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [166739059013690907; 170576690871425173; 680619525622334624]%Z) 1 [] [(7, 1)]; Term (- Replay.long [68427203096318527; 370039341076490606; 508244098850384736]%Z) 1 [true; true] [(7, 1)]]);
     (step 10, [Term (Replay.long [1; 751619719906032435; 778957469928740806; 574605384604323424]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [1; 405751360813994700; 078091743787981186; 456750213755491072]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [379190691444339972; 608480648319682009; 297877257000648512]%Z) 1 [true] [(6, 1)]; Term (Replay.long [323590365317674906; 244691364375790894; 163672083143785936]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [741729702658160641; 814512040162292183; 906488325945467424]%Z) 1 [] [(7, 1)]; Term (- Replay.long [301906011129731446; 791830438350077329; 387394859105201536]%Z) 1 [true; true] [(7, 1)]]);
     (step 11, [Term (- Replay.long [644699896896; 446969032672906536; 539224082984567040]%Z) 1 [] [(1, 1)]; Term (Replay.long [263207690756; 708985048224536500; 166735102794274560]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [557837355899; 414080516961596331; 617417210289159808]%Z) 1 [] [(3, 1)]; Term (- Replay.long [230122537265; 303912443810070984; 453839645670056512]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [104428623518; 532367167421621976; 476734775093826304]%Z) 1 [] [(6, 1)]; Term (Replay.long [41255210735; 512418548912338135; 105482108282057856]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [112173471615; 214075521473182386; 156227965925344128]%Z) 1 [true] [(7, 1)]; Term (Replay.long [92486647766; 052697573806621625; 784222522468889984]%Z) 1 [false; true] [(7, 1)]]);
     (step 12, [Term (Replay.long [59050379; 340905466457664519; 534412076219164000]%Z) 1 [] [(3, 1)]; Term (Replay.long [13476451; 329719329604759417; 968299819570542400]%Z) 1 [] [(6, 1)]; Term (Replay.long [8390542; 315085894020478126; 470513217475836400]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [10863464; 981217054451883624; 862366628889300400]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [240470; 672085786012677604; 893362212113644800]%Z) 1 [false; true] [(7, 1)]])]
     44523206091600 [Term (- Replay.long [27094; 387143270305276474; 763574337471704224]%Z) 1 [true] [(7, 2)]; Term (Replay.long [21841; 821265826319016515; 705106441902635472]%Z) 1 [false; true] [(7, 2)]; Term (- Replay.long [2803968; 858717007280397458; 718811683449870832]%Z) 1 [] [(0, 1)]; Term (Replay.long [1139819; 515654760744596319; 788692038304068448]%Z) 1 [true; true] [(0, 1)]; Term (Replay.long [1682434; 547509323608085312; 408567526624636176]%Z) 1 [] [(1, 1)]; Term (- Replay.long [684407; 642236799203982212; 886485365875970864]%Z) 1 [true; true] [(1, 1)]; Term (- Replay.long [3645086; 872071012357492559; 353775232222471736]%Z) 1 [] [(3, 1)]; Term (Replay.long [1497021; 534851376318990580; 880248268553915204]%Z) 1 [true; true] [(3, 1)]; Term (Replay.long [1215494; 088279635657098187; 724413778149252754]%Z) 1 [] [(6, 1)]; Term (- Replay.long [493074; 228951012456850334; 064621061363352406]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [1274830; 036368147146888878; 902130720830077766]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [1044094; 350953582452466781; 671637656660661498]%Z) 1 [false; true] [(7, 1)]; Term (- Replay.long [44184; 639715714781201999; 272845166941489981]%Z) 1 [true] []; Term (Replay.long [33814; 808995281307297507; 710747990363723268]%Z) 1 [false; true] []];
   (* 14: ... *)
   Derive [(step 1, [Term (Replay.long [30054; 879257440654085347; 347962326495093143; 065957180870071446; 977143751969860941; 123483260857800973; 409571241547804400]%Z) 1 [true] [(0, 1)]; Term (- Replay.long [34516; 236372023237251728; 075706301353174794; 632366136999986374; 214272540455725188; 818213823427956526; 231800638609283200]%Z) 1 [false; true] [(0, 1)]; Term (Replay.long [200898; 550504154953931635; 064728067483543117; 526510370516920461; 344661671750677514; 176623792346478313; 346597149781150600]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [163580; 296597300010580400; 053971551635888177; 087224855855186076; 001108840252226414; 665476409486869375; 662918939189926800]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [75951; 730683107971311742; 411546553210486491; 773321034214725103; 517788876188336142; 014634932602927703; 741917347763458010]%Z) 1 [true] [(3, 1)]; Term (Replay.long [58638; 526629998310423333; 425899105984836683; 570639895775843741; 423360166382229002; 720092412022679349; 144561822116282280]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [20289; 982717584305461719; 545362415757991177; 951915559731007482; 078858953740759355; 160821823574291419; 351877958181672275]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [24830; 344523477430284923; 301850244543207494; 263322530144659667; 463464544042629030; 725231435188037249; 565323971652298700]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [116615; 193428337300302307; 324967366636182376; 642046246913856789; 543154594411059832; 015795785266553025; 883226773510367440]%Z) 1 [] [(7, 1)]; Term (Replay.long [49180; 541905817595962301; 937320741812891779; 047321333285842773; 941774282347080863; 522386329795391271; 316642406552228910]%Z) 1 [true; true] [(7, 1)]; Term (Replay.long [618; 305689759250419014; 032695650492139683; 802815264745995687; 649906190709729154; 648581574684514928; 341234435227293525]%Z) 1 [] []; Term (- Replay.long [804; 758436431296071867; 878818573171412492; 735846223414677153; 236698026266144781; 306560595457380392; 836491075117490600]%Z) 1 [true; true] []]);
     (step 4, [Term (- Replay.long [1032766; 226087410649788431; 276680139325733007; 738041199880874016; 352688829194695561; 531101522756825987; 285796518457996800]%Z) 1 [true] [(0, 1)]; Term (Replay.long [907799; 025376538408573183; 988575287176369902; 717224877274689366; 227830245329861162; 149361272290369639; 214571675275750400]%Z) 1 [false; true] [(0, 1)]; Term (Replay.long [553940; 437291365245130183; 361237608912692728; 218525143337591819; 792010112894989403; 526532295582814598; 404631697365497600]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [497056; 595971930851687255; 104361598987364283; 235325817725229624; 148288937025607584; 726077514934748391; 141357329449132800]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [142803; 991022631548552978; 120541263664436129; 894280843716115711; 131043515737113071; 268841230679925899; 422518639927286400]%Z) 1 [true] [(3, 1)]; Term (Replay.long [104343; 776555912099780531; 790762198291275357; 014237559883678430; 901766053302489290; 719263362141951746; 149845078263299200]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [285398; 847714051612445373; 012808184678680693; 577454424606561125; 557625657535446709; 623915660843973191; 330492284470784800]%Z) 1 [true] [(6, 1)]; Term (Replay.long [256757; 999456460042652395; 082883226491890087; 372882142915819172; 791045194739566218; 432121029798437701; 747312756191644400]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [811491; 885800391821299233; 246847051615203828; 889966135528837969; 804371613619972516; 774094212602734813; 479065019141172000]%Z) 1 [] [(7, 1)]; Term (- Replay.long [314743; 938827468623189165; 222678179483423534; 481098099469787616; 135858248767685562; 254186873970357006; 932459914598418000]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [70868; 175921942570520029; 880372231306925442; 610683944279085470; 561183141350441260; 987875357586659339; 406372218878247600]%Z) 1 [] []; Term (Replay.long [36060; 674000235155995954; 065904198801403875; 760451901816814859; 016808331042186367; 523930448358910840; 835403611492366400]%Z) 1 [true; true] []]);
     (step 5, [Term (Replay.long [4773382; 330921801259231235; 122362692152862398; 310872359613521812; 204651550943363722; 656626010482770017; 852748699985702400]%Z) 1 [true] [(0, 1)]; Term (- Replay.long [4202518; 321440918398891088; 806310316364532060; 014519393739163346; 090851888855388443; 349268252505486395; 644762661829427200]%Z) 1 [false; true] [(0, 1)]; Term (- Replay.long [2820290; 227074628844210827; 713056526461265352; 090613171694388925; 720603185356344049; 546270949879715923; 953084461466176000]%Z) 1 [true] [(1, 1)]; Term (Replay.long [2377702; 888911909172806718; 281885838771956870; 764137551604406306; 504408919032849819; 421990001271231156; 131628672046208000]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [4923834; 521564495146275638; 859172463723556359; 389902209857244018; 987553826644631364; 895866145028974186; 714566588206464000]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [3834108; 706173347018541366; 890427873322828604; 695531335841533343; 746515048516887481; 851437169055529498; 056279898048032000]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [1316953; 474675233623689186; 817760042893832801; 671652687805452847; 939414317617677774; 723328801339371669; 466118291760660800]%Z) 1 [true] [(6, 1)]; Term (Replay.long [1020204; 449726558317114188; 148390967933856163; 811291782577796520; 201475207624276498; 945918068131592335; 430774291941062400]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [4997564; 683751620304854437; 126741903652717533; 102207334694915940; 711482805992565004; 651867865622526610; 843121359148691200]%Z) 1 [] [(7, 1)]; Term (Replay.long [2055094; 773611368665609818; 462612608806881019; 032698806158354504; 831908552312707240; 749040092632371940; 212804243290476800]%Z) 1 [true; true] [(7, 1)]; Term (Replay.long [211300; 310660276365132458; 139395162869370232; 237429681456575040; 645049128775943142; 217521976972568428; 808395040273843200]%Z) 1 [] []; Term (- Replay.long [108104; 368142484366490198; 935366152181861329; 161893584014564007; 940385344484923003; 868259826073579983; 895968374889084800]%Z) 1 [true; true] []]);
     (step 6, [Term (- Replay.long [190122; 340460798526016909; 010187731900205480; 331053050658953304; 866006023761710964; 213116010832790888; 908092953543865600]%Z) 1 [true] [(0, 1)]; Term (Replay.long [206904; 749650685052095615; 383537589831299671; 440234485839641409; 078608330207372062; 136900753383124389; 414570079365196800]%Z) 1 [false; true] [(0, 1)]; Term (- Replay.long [904188; 062513191401820150; 383666886188503938; 201103156732339736; 326005728535536490; 052605788811301042; 243591199086956800]%Z) 1 [true] [(1, 1)]; Term (Replay.long [734780; 855767254955274033; 367866336045348993; 585272149090121876; 596689184709007339; 992932085436650735; 462880753619430400]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [161195; 473211774909033431; 586523172771384992; 775113588494103454; 857201572392950238; 509453798519094664; 224327227578265600]%Z) 1 [true] [(3, 1)]; Term (Replay.long [84245; 034279552727064906; 756102328257229242; 082067652036154480; 709729068823093631; 891047193148656066; 606786925902083200]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [243202; 138250984846642204; 386618467655895444; 274957351370705639; 049848808034880809; 380762543994998663; 623204930190284800]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [43832; 822474814670864296; 226274206423725137; 366657788181056606; 390646761325325758; 286203782162413763; 218661712726414400]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [1567; 753005952614032189; 690515479476270112; 398813920115267944; 850642799258577317; 742633590273741215; 929952518778308800]%Z) 1 [] [(7, 1)]; Term (- Replay.long [21; 683197279936144245; 365709406160714279; 431668687908547226; 144311400641791345; 739250552595378628; 459687173523196800]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [2767; 402608295899868352; 776935198020614782; 475813999060166174; 123204878152143815; 174947252395178044; 727083376029414000]%Z) 1 [] []; Term (Replay.long [4459; 804548655146911778; 700500476309131168; 201147703932877883; 697917726101145002; 956331277270433134; 769431666804976000]%Z) 1 [true; true] []]);
     (step 7, [Term (- Replay.long [563836; 425061753194859370; 481888997288993560; 472031932484767184; 997336911583259034; 795563641160903734; 288564492997094400]%Z) 1 [true] [(0, 1)]; Term (Replay.long [355247; 772981923313575765; 544032924617331994; 638184146898940703; 380585597058927263; 250443816895272059; 912024707009203200]%Z) 1 [false; true] [(0, 1)]; Term (Replay.long [507262; 158016836118845491; 578329734143454126; 333043226625312462; 192662645577479253; 963671025806861495; 714682875317542400]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [436566; 386192931541191861; 432460194703741988; 579372347976779997; 896535684693525653; 533603181185017459; 160441304372147200]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [766176; 238151923527212704; 604478538515938437; 567339668233249307; 808680643309699144; 966537332151706334; 258323071476796800]%Z) 1 [true] [(3, 1)]; Term (Replay.long [347662; 205025424204686649; 869397585848983337; 663041453983663750; 433171814115306936; 047738697697374142; 564126343628550400]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [70958; 291602751114092048; 370168055155523391; 689028991362375019; 031860692841546519; 723820956539813814; 856150562868836800]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [147735; 895507251565028741; 043264901605722901; 329196942851638288; 205869881903884743; 888765727207039503; 865386464244149600]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [660297; 495327956874405128; 369998565473189458; 147949972500943367; 981827483786036436; 796873160739136413; 554141638291585600]%Z) 1 [] [(7, 1)]; Term (- Replay.long [270581; 583768044386678274; 232190620045279252; 687616074204248986; 996410611478613126; 389113692875734996; 068609608026978400]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [48340; 582029410376864989; 264937183262458137; 443629605337520889; 937481589898056530; 494300975553466130; 082504375919354400]%Z) 1 [] []; Term (Replay.long [18094; 610434765709182875; 397515123320473019; 497488865139787777; 886304176018238719; 550280299969983969; 756250622420321600]%Z) 1 [true; true] []]);
     (step 8, [Term (Replay.long [2436073; 773482260181790291; 546545007919712619; 693648859417467605; 415251633935932435; 186226054587316571; 979646452878572800]%Z) 1 [true] [(0, 1)]; Term (- Replay.long [2072893; 904225064874836537; 163486825635278331; 151557722101162385; 921142314859855667; 135731092321675790; 475403117096678400]%Z) 1 [false; true] [(0, 1)]; Term (- Replay.long [754221; 922466113288264880; 915140975751462709; 645532306466624130; 096821590045644268; 492985065346044350; 204183525603654400]%Z) 1 [true] [(1, 1)]; Term (Replay.long [667203; 072484399666058247; 744620864261725390; 011439704542954281; 175780014258229299; 731229179424237825; 483472842099763200]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [1955470; 040311011149499699; 903949522381553612; 671856334348634631; 194731304393435231; 504128904454735708; 334202571962905600]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [1831985; 649875536179609649; 703949843613917022; 553401723680766100; 531308540700959232; 128503837900725684; 587668173188556800]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [638204; 818617655240867412; 221334381814938131; 311058674658231349; 290224745663709132; 747547588201660606; 433358713096195200]%Z) 1 [true] [(6, 1)]; Term (Replay.long [335841; 293844011075994382; 935428651121804615; 789175870938938725; 015051934563545714; 693250998190840440; 499355185044105600]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [2660147; 306756491047191002; 732777269840528926; 115990926689439376; 866793829148440503; 058040524973003960; 232529073763148800]%Z) 1 [] [(7, 1)]; Term (Replay.long [1076085; 186211761710763797; 256571228447557447; 313578147555481047; 828618171091886002; 375567576463542333; 608207041867563200]%Z) 1 [true; true] [(7, 1)]; Term (Replay.long [124102; 787211071620501918; 401938251936898813; 172299402152580499; 315080427117466059; 372756988409762391; 676132528900867200]%Z) 1 [] []; Term (- Replay.long [60066; 901370269054023716; 615092567009754477; 939671445804961252; 480726462379715569; 365094449972345343; 354606046862020800]%Z) 1 [true; true] []]);
     (step 9, [Term (Replay.long [2557; 488675773958993858; 330177934960496657; 599539931344929863; 416173773160561042; 041553809213410873; 731291847313977600]%Z) 1 [] [(1, 1)]; Term (- Replay.long [1006; 754426960796149260; 722960574084988545; 683053330436065018; 922258303801778834; 677426473019508219; 800556050533571200]%Z) 1 [true; true] [(1, 1)]; Term (- Replay.long [119; 687094948917874542; 196542581049938048; 723706382037419596; 725887721443559675; 397152349810715477; 135537107502564096]%Z) 1 [] [(3, 1)]; Term (Replay.long [101; 618857557201056304; 105614524320153694; 244270140769773456; 359483744605006348; 977158736855223997; 115212829274799744]%Z) 1 [true; true] [(3, 1)]; Term (Replay.long [567; 501603060673918036; 688872270465314611; 284675530187586846; 405892954513338652; 400149948081539036; 305460120844278400]%Z) 1 [] [(6, 1)]; Term (- Replay.long [230; 165119515108817843; 977126852645717469; 316848614097398179; 669579945572960080; 368586298404129366; 879704633537965200]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [277; 363679155268453500; 875785557987964916; 007086944105189814; 684157911601037210; 081470421582135103; 796781468906837472]%Z) 1 [true] [(7, 1)]; Term (Replay.long [212; 429237794666279607; 563577953559128133; 435431580379693892; 878086914453877409; 353030277240807975; 745667891190244416]%Z) 1 [false; true] [(7, 1)]]);
     (step 10, [Term (- Replay.long [2738; 742878759303830544; 892668070712649420; 948718847192692766; 578392769593175755; 443064337368836009; 203252993825914496]%Z) 1 [] [(3, 1)]; Term (Replay.long [1607; 491610853287210527; 652511380167190712; 168493721265904990; 746560497822495243; 591765962873504023; 134145351993593344]%Z) 1 [true; true] [(3, 1)]; Term (Replay.long [2848; 379227836479115460; 994559703322856193; 412459723915578769; 394741721707047066; 941847923005979146; 214550997463546800]%Z) 1 [] [(6, 1)]; Term (- Replay.long [882; 834942956242710051; 994875150485824315; 718791539645794796; 098941471270209286; 128335847847371061; 136536739433295200]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [3415; 914959518867660275; 218331411006995608; 881254000929320512; 871183579516781866; 268997306322245050; 917329146717338672]%Z) 1 [true] [(7, 1)]; Term (Replay.long [2823; 415471271642584879; 558215160413503371; 587238788832488712; 065789971773417227; 467575498094860521; 222959796639388416]%Z) 1 [false; true] [(7, 1)]]);
     (step 11, [Term (Replay.long [4817514970963319; 057015670727419269; 673080344768824546; 293259471582953332; 957141096736072632; 083189958800773376]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [3933082013677999; 554333149502821156; 366577654682275129; 605353428311330891; 459868181463130233; 390027822064899328]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [2581090069020003; 942949935516505376; 997697470398930052; 077924583903110508; 486811137017830084; 130907853719994944]%Z) 1 [true] [(3, 1)]; Term (Replay.long [2012587905905653; 173658787893444902; 780938277125932124; 589080887383917902; 013729357185970788; 990175666878549632]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [732756023602165; 355424152402212598; 435236747340341614; 285885146937190345; 372139702901929850; 701518543922989440]%Z) 1 [true] [(6, 1)]; Term (Replay.long [543164634878738; 460441108572869454; 885552128977117613; 614157259386167417; 386184058086458751; 792021152039416320]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [1327271095141489; 526855190941408059; 014953335125714900; 994377657687309687; 812205714616352445; 360391562724979200]%Z) 1 [] [(7, 1)]; Term (Replay.long [560111704880719; 925743238324030140; 285975403928555525; 043737704021120324; 612587896910540796; 940606491950588800]%Z) 1 [true; true] [(7, 1)]]);
     (step 12, [Term (Replay.long [479745277776; 538139918303449274; 165834482198716190; 731211474804052194; 267368760853670499; 491487580652340800]%Z) 1 [true] [(3, 1)]; Term (Replay.long [566604788714; 977023573541285936; 726489271320176918; 841930330714751599; 842943074571807013; 125159063156725600]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [313151062546; 156834398059502658; 749090388651755107; 576492617604002035; 514927385636619620; 089655310358516800]%Z) 1 [true] [(6, 1)]; Term (Replay.long [300266992696; 514176976366110135; 745940025456834397; 752035420960189656; 522118961202303937; 963392382344697600]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [286964164568; 201797008036874972; 568981184154204302; 651941295704440522; 281747638065932260; 532825529211601600]%Z) 1 [] [(7, 1)]; Term (- Replay.long [68153934751; 239931179261307105; 038934361319814220; 616438710479082671; 601470648861054162; 457464226040729600]%Z) 1 [true; true] [(7, 1)]]);
     (step 13, [Term (Replay.long [20; 707066395269957447; 494492004734845424; 038251140673595709; 288398784284844800]%Z) 1 [] [(0, 1)]; Term (Replay.long [438784244138878197; 448232481510376165; 188756700625020016; 036801148635616000]%Z) 1 [] [(1, 1)]; Term (Replay.long [744399815578275661; 664006840003844906; 097688875882922676; 838597253494617600]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [5; 947268713376309023; 534983661559615582; 665826629826438913; 247315055022604800]%Z) 1 [] [(3, 1)]; Term (- Replay.long [6; 380919512540825474; 011920806945532445; 883367506922930543; 779109088246156800]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [4; 585567157441666234; 737005158839082414; 365032577486679754; 071667520079995200]%Z) 1 [] [(6, 1)]; Term (Replay.long [2; 497258695872387382; 852082993128601983; 256432154062954322; 451941612205019200]%Z) 1 [true; true] [(6, 1)]; Term (- Replay.long [6; 345791929369745614; 892512431832064563; 866941419200497628; 581659382789083200]%Z) 1 [true] [(7, 1)]; Term (Replay.long [4; 439236357885113006; 013307991703081461; 535423478049184501; 790873184707313600]%Z) 1 [false; true] [(7, 1)]])]
     24042531289464000 [Term (- Replay.long [75; 274783398702422965; 789674999850441179; 172088927775135002; 074843895741083701; 268420668449731299]%Z) 1 [] [(7, 1)]; Term (Replay.long [30; 777051092231026681; 954071766180641191; 266255138652316276; 587398362619750466; 633716544778490536]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [1243; 483207753531159440; 604703124556158229; 337085782851816034; 094744941549316788; 851513906475599535]%Z) 1 [] []; Term (Replay.long [507; 618483993405263553; 558295674577619984; 329314005768210766; 216227084253442162; 886790802111953815]%Z) 1 [true; true] []];
   (* 15: ... *)
   Derive [(step 1, [Term (- Replay.long [52470967623; 286961985749277835; 392085032411939616; 549370051891860323; 892422284919226334; 567053217159855437; 148780849816735400]%Z) 1 [true] [(0, 1)]; Term (Replay.long [43502887778; 656292784835386524; 045218480209826296; 851356892361737603; 245060056640308394; 175402469624433227; 103743410823283200]%Z) 1 [false; true] [(0, 1)]; Term (- Replay.long [293368791451; 225430103888736464; 906836558782369931; 609192895969664677; 170039717008479671; 414712287961919622; 971914066816708600]%Z) 1 [true] [(1, 1)]; Term (Replay.long [239504652617; 746310120210710291; 032124496724712376; 434227065060521860; 864788190361529054; 646898086196517799; 988754699106229800]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [108197344562; 304376749769653023; 623734904850362616; 751161732704709035; 983931908612212658; 792674601531165573; 133266779584421160]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [88119276602; 764810324212640204; 416524410546119445; 237597029517248169; 010497651596007009; 796988827136960219; 636296812534312230]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [36736278679; 939171130438093070; 588934390695297322; 616545541942432664; 496717792816165958; 887137920686941024; 903988543081868925]%Z) 1 [true] [(6, 1)]; Term (Replay.long [30542140393; 833198391794942367; 955158657692958622; 397449063556525331; 366179776833534873; 367893292155037448; 389623218523693275]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [173217966238; 698886611423019827; 651088811250912887; 899927235880290752; 003116534945424672; 674395584225909571; 036639337085956990]%Z) 1 [] [(7, 1)]; Term (- Replay.long [70820047578; 055631466933078966; 751627470353204759; 662561879383029816; 620592025219912330; 739057314438204772; 525463748068669985]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [1848140291; 889761265477131892; 589766927134790739; 557285845256641421; 377203188282437162; 881742585795116839; 202072357504083400]%Z) 1 [] []; Term (Replay.long [791066404; 002335350426891566; 352083194812745300; 180363751680965076; 043091099965089460; 898786839586101320; 123975013789362100]%Z) 1 [true; true] []]);
     (step 4, [Term (Replay.long [1565352973657; 591244578492520770; 407064845464470406; 431131035744642471; 006565969288943595; 993997545590736157; 082416402455116800]%Z) 1 [true] [(0, 1)]; Term (- Replay.long [1282378803566; 137228120972265823; 859186910285517934; 471232661233017145; 085462375400039606; 268348356953365155; 992379525035270400]%Z) 1 [false; true] [(0, 1)]; Term (- Replay.long [848270903941; 239965339949712807; 034078045878212928; 107144412664899974; 189067665087010917; 302912356285024876; 116725111542905600]%Z) 1 [true] [(1, 1)]; Term (Replay.long [695574054504; 916685532049746066; 309669286778978389; 425555097491145915; 347788429097508832; 562455454497319821; 672391350946892800]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [198333296168; 376488893288050189; 954992327604853274; 844004750216096937; 018999292888767497; 065922763955619632; 708950581520036400]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [161127372316; 542887221515315271; 719817087741224120; 729728206258699419; 388412767568709912; 690226679017641745; 549321591590427200]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [437591215845; 753818811468362455; 453693661854223542; 224260081338622295; 906176764966598779; 233742528997736527; 080024096281943800]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [358862978603; 677690389027303946; 235434264601951718; 229136430570131763; 970211819014602835; 607990429090087077; 721431831537790400]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [1158345312253; 791546108833013711; 250543701245640499; 464887390664312671; 716996013668524407; 191665930958634178; 496493524226538000]%Z) 1 [] [(7, 1)]; Term (Replay.long [471797030221; 073301246926762530; 390210671309312692; 122596943069040773; 594771124299767986; 103512265693295859; 018453395699215000]%Z) 1 [true; true] [(7, 1)]; Term (Replay.long [115812258601; 589330463658882407; 863418203240520468; 609489807728594741; 310623100852586447; 945472069464057810; 575499775875763600]%Z) 1 [] []; Term (- Replay.long [47752098126; 785116193682239842; 721780194684372469; 528571320801676900; 508454851478284366; 350000990794713820; 520467650715423400]%Z) 1 [true; true] []]);
     (step 5, [Term (- Replay.long [7240612943472; 180153522171302492; 796914445919346333; 394404289610392042; 993699438494872044; 701663332244155008; 336750461248742400]%Z) 1 [true] [(0, 1)]; Term (Replay.long [5932133295949; 272785083796150327; 061267432917515328; 241144107490769267; 247908036940887532; 151797737616979688; 328167899991859200]%Z) 1 [false; true] [(0, 1)]; Term (Replay.long [4188011636385; 835259195715236208; 237543199081378452; 658030419155964210; 364276288898861517; 460660325498180541; 921261945452480000]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [3424458867313; 123701558137329579; 953701894995072240; 242950940523412226; 500040287278064757; 039448579132142802; 094594220361344000]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [7040669018263; 812095093216414045; 415397936029362150; 641932999680979635; 460681268061832738; 878167191396504232; 751832599904960000]%Z) 1 [true] [(3, 1)]; Term (Replay.long [5736356105105; 731586628015953957; 323103382783758740; 496055253381257570; 264452398153251835; 473200095058274011; 406588183847712000]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [1878711542535; 147625925953097960; 397260827010767527; 308865874693022490; 074570497902381500; 203119566179587480; 029407116708340800]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [1530314374367; 176109763017284119; 164436348384234301; 264494392747318760; 491150405363865832; 575878221264929601; 615285548818438400]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [7333157067423; 123807286019341053; 579822359283639917; 831473090255863849; 217442544877036057; 617369016083729996; 622975655392795200]%Z) 1 [] [(7, 1)]; Term (- Replay.long [2994731803845; 563643631336035137; 970870493940660713; 285725237370158132; 689707875393429511; 628300547653934233; 376384762954628800]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [346301634517; 024504330276648640; 001332656724831350; 437858482980494738; 026512021114724598; 714138309916229681; 519130897885363200]%Z) 1 [] []; Term (Replay.long [142823016457; 355258010920399633; 204125984972337490; 510147869294493636; 805794605865384239; 489970547872315477; 244377048396044800]%Z) 1 [true; true] []]);
     (step 6, [Term (Replay.long [322143291825; 568300651189807322; 111813141594204318; 781112125366881164; 214035918908951659; 455910175571930662; 388471672699785600]%Z) 1 [true] [(0, 1)]; Term (- Replay.long [266449863476; 750894798975485773; 018900596223960075; 436418509499123958; 956887440605532574; 098345601312265140; 072005246899660800]%Z) 1 [false; true] [(0, 1)]; Term (Replay.long [1319144478941; 813100916568069894; 653381191026996465; 276208053865941455; 714602537324322007; 572890873388534716; 350395894431676800]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [1076846218689; 094513664863767808; 043019776258639311; 820920943796581339; 408604852451049418; 524505769392861946; 935852964405990400]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [51121889136; 095679508495540022; 150766158393068691; 991281522577841396; 371594755260617273; 222327801047825777; 429196235177689600]%Z) 1 [true] [(3, 1)]; Term (Replay.long [27449950265; 395948461435973256; 120549121544735661; 107619543170771565; 791794341679326659; 700575667447193727; 683993899222668800]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [223346359779; 478491662946478310; 699986714215349288; 463458121827071046; 050428634115008149; 016843328109454302; 019007047097198800]%Z) 1 [true] [(6, 1)]; Term (Replay.long [172117015709; 080819084938767990; 579051256110547593; 435851058672375875; 399528030265960431; 246551170929643456; 533128901245326400]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [1205439401; 503637850261621292; 227166385267398137; 825003416332165237; 508476851693013638; 345692630169397535; 282394105337324800]%Z) 1 [] [(7, 1)]; Term (- Replay.long [448390315; 082126370400302987; 875407495052617186; 561606236805741203; 854877902418045457; 332956420094013847; 760206751826045200]%Z) 1 [true; true] [(7, 1)]; Term (Replay.long [9738000214; 880002930452819192; 587932354837838647; 699028200170643998; 652280777203243511; 894899838621487825; 877110743002616000]%Z) 1 [] []; Term (- Replay.long [4195981894; 636142045476234273; 106580946769397012; 459684444413509996; 223127986197823198; 351860329872610863; 923443671673708000]%Z) 1 [true; true] []]);
     (step 7, [Term (Replay.long [734623518666; 467428062564452885; 219385556848881246; 928780349328745336; 757427896645213870; 893326363857976863; 659856580470502400]%Z) 1 [true] [(0, 1)]; Term (- Replay.long [592857744324; 951332979633829417; 503815853489801547; 624747366798908009; 231488446255560726; 713035063998047832; 159041363789299200]%Z) 1 [false; true] [(0, 1)]; Term (- Replay.long [760878262007; 899772335502940973; 592966517300306972; 813863543419845100; 493422030977841651; 282144682866929217; 283029752127334400]%Z) 1 [true] [(1, 1)]; Term (Replay.long [622736788493; 564095319198593635; 032362916562217306; 952006284647278061; 446087671512714539; 926205188122847378; 136730212470195200]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [882700449719; 719324917555501805; 688882270545128801; 024785301619836229; 396480185752495979; 278002219963870169; 703569274847264800]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [702322647994; 503984931339606319; 926721168239624953; 963635589942131832; 124520875603323477; 211653145572453707; 982935184596534400]%Z) 1 [false; true] [(3, 1)]; Term (- Replay.long [72082504827; 720279452836432221; 016057723925578842; 849407395461071512; 968670973187328310; 778105687169389861; 782773437321457200]%Z) 1 [true] [(6, 1)]; Term (Replay.long [72471502368; 575575940249956192; 097034691786507333; 414337727288749925; 296021001165080482; 273781663136241428; 441000013109817600]%Z) 1 [false; true] [(6, 1)]; Term (- Replay.long [967329185005; 881526060610773214; 142975245716144049; 503551841858462089; 431530490986544256; 278881224955232072; 957078258342229600]%Z) 1 [] [(7, 1)]; Term (Replay.long [394977895926; 758723358468617084; 626086986894822432; 574462385570052501; 715149110810601595; 079770672917892936; 135169504603736400]%Z) 1 [true; true] [(7, 1)]; Term (Replay.long [67880145348; 710492197515196338; 026609925432483468; 684448764914984596; 670783847158061257; 861928026891417290; 463492426817254400]%Z) 1 [] []; Term (- Replay.long [27603355247; 710185908552369769; 279194448114628094; 864396906600523676; 064139021291302039; 485024768661152050; 163350700034811600]%Z) 1 [true; true] []]);
     (step 8, [Term (- Replay.long [3633776524746; 164025440198021610; 892597363880454298; 761719310709455438; 372618400452722461; 344920541719398592; 801095182431500800]%Z) 1 [true] [(0, 1)]; Term (Replay.long [2972517393198; 058644064893307700; 409192032578611020; 572366769772178824; 547378216251482344; 149300105081010356; 659752519037222400]%Z) 1 [false; true] [(0, 1)]; Term (Replay.long [1146749988626; 490294138078492732; 260188807457191580; 740283647778377732; 746377440048232734; 523453490226980383; 130949471629990400]%Z) 1 [true] [(1, 1)]; Term (- Replay.long [939719281958; 957566883623304330; 317467385017084344; 025559948904706924; 662284262715141514; 801198032705719965; 295034534171187200]%Z) 1 [false; true] [(1, 1)]; Term (- Replay.long [3060474907436; 521780240433989784; 485006549201052823; 661840893012300648; 450125017891620351; 393313701233069580; 166657022879529600]%Z) 1 [true] [(3, 1)]; Term (Replay.long [2514448801876; 776159934419272812; 438812599285209718; 043191766589865747; 011100023266616496; 076393302086890197; 373607775854844800]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [774876575505; 021437479056610933; 625665957519120895; 370597256377458564; 795553998054946362; 308699844460287379; 128669623385359200]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [620419491342; 785376238586031030; 226947963731281133; 351389098985257231; 842242322897703611; 651383135772815150; 001940821371281600]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [3872903322288; 648898129209814079; 310892035611964953; 171034031118506104; 939601842705682900; 712227024457591498; 269180524301636800]%Z) 1 [] [(7, 1)]; Term (- Replay.long [1580449635930; 950448049829748921; 600942199566184710; 431535804993364069; 344353699452885358; 416732691324472079; 688423966815063200]%Z) 1 [true; true] [(7, 1)]; Term (- Replay.long [197534440719; 171972817641567084; 400537587317220088; 374114346618803451; 136771147554875743; 761970932681057008; 199038381772723200]%Z) 1 [] []; Term (Replay.long [81265546882; 826731818785461232; 423109419939293524; 590431243239791371; 239912075106830528; 282841598455804533; 343064993102684800]%Z) 1 [true; true] []]);
     (step 9, [Term (- Replay.long [3675713095; 388297953314414251; 246371377545750811; 959038971109379727; 105664909033783491; 690652873964596943; 600119563081275520]%Z) 1 [] [(1, 1)]; Term (Replay.long [1498131750; 442958519493158481; 475328052433413534; 317560150790507559; 835768806796736741; 180299668544952346; 780488693477592320]%Z) 1 [true; true] [(1, 1)]; Term (Replay.long [265393348; 435693401246107284; 222456730819381236; 067455826003656952; 960801663884912610; 008710298577126823; 737051283383036736]%Z) 1 [] [(3, 1)]; Term (- Replay.long [111839123; 125479232038009366; 088835476312893135; 803240686659861964; 030065399256729362; 833801907711267249; 596393485447334304]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [827242755; 336523056608676483; 297310481992523448; 181210821350547524; 279971942641980890; 856891699143916179; 363601027926406880]%Z) 1 [] [(6, 1)]; Term (Replay.long [337620073; 873891162328453257; 286082369820255816; 128350808389895739; 669461089562189000; 736182252839863445; 560062501349168800]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [393683372; 377204872372245951; 301844204366961937; 068043321764580057; 840977897346214620; 945216246554845390; 697609948601649632]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [320511729; 370697674970810459; 407404770442251437; 405957057102859644; 323978273215463943; 416051605267415768; 902090971322291376]%Z) 1 [false; true] [(7, 1)]]);
     (step 10, [Term (Replay.long [4843339697; 935739827202406274; 564977897639699204; 889584578694910146; 724892893858004535; 171928647642866007; 099594973484886336]%Z) 1 [] [(3, 1)]; Term (- Replay.long [2009685918; 917983097606444916; 744212733605147784; 877366187891796727; 747592071363636253; 708885981111425767; 333740412138193104]%Z) 1 [true; true] [(3, 1)]; Term (- Replay.long [3686588166; 445220763993687790; 466003481112217504; 900228219890930459; 412389441571147507; 751756595243381983; 262901614273242240]%Z) 1 [] [(6, 1)]; Term (Replay.long [1486505426; 558727326822552075; 077365584847929979; 703287393427042282; 922809401606813213; 743557602976498296; 146936544177528360]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [5024660498; 157274660654706634; 760652994548162297; 753318487356723024; 770487691526710544; 616174535321700387; 941735314715213912]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [4104891391; 854291718414791096; 997164519735308825; 821763437235785513; 485637012246102599; 368214898551181299; 415960892400353136]%Z) 1 [false; true] [(7, 1)]]);
     (step 11, [Term (- Replay.long [7044; 353723831524449334; 096514011249728683; 932191747686662973; 360819089548870302; 713675545098303397; 676053936021277056]%Z) 1 [true] [(1, 1)]; Term (Replay.long [5751; 664083413463859812; 188992722018514318; 569625575564477360; 664327068821617017; 421857601626023268; 414155640756154368]%Z) 1 [false; true] [(1, 1)]; Term (Replay.long [3693; 384112985462491254; 777195919694258134; 281783083196953172; 431865770650823245; 220614664984606296; 708257258811022784]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [3009; 354961442839022971; 037387332616288649; 691248002515881339; 321205199717176172; 463539975406058912; 499161194516793152]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [1024; 248961887719629284; 402708304271667292; 429110004441046114; 544029980187756511; 449854705255356817; 919323883575695360]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [832; 646038467259729005; 633670199417100854; 198352276566422764; 287645100913268836; 387964335382990778; 640722960639358080]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [1971; 822474693838123614; 608480189614049597; 733320414600158508; 126947585501626001; 923243713632381146; 455324321947552320]%Z) 1 [] [(7, 1)]; Term (- Replay.long [806; 201686125641996829; 637493051683052104; 035476340353307881; 698652789021204519; 335391594165665297; 699233475611540480]%Z) 1 [true; true] [(7, 1)]]);
     (step 12, [Term (Replay.long [117763127321975170; 857402735791896542; 442329496354389510; 290705305519067600; 727868328095545337; 542457057826614800]%Z) 1 [true] [(3, 1)]; Term (- Replay.long [159599588167243496; 028301923250017037; 204123745306603146; 187485452364793990; 386038743987818636; 942888718694712800]%Z) 1 [false; true] [(3, 1)]; Term (Replay.long [17375895374825858; 482629675598612514; 923859486529952954; 175477573615189918; 612555919942816734; 052290152351495800]%Z) 1 [true] [(6, 1)]; Term (- Replay.long [50994047903746655; 374704618663874124; 588135375698892928; 450915062463072636; 562291280856840550; 736485914698920800]%Z) 1 [false; true] [(6, 1)]; Term (Replay.long [102766829401506031; 144081208032791689; 070451754494072885; 551435466972267979; 000823631795532441; 377938205619548800]%Z) 1 [] [(7, 1)]; Term (- Replay.long [29686936087153956; 943633555580059049; 169184426644252021; 071311807721547918; 018600712022189762; 576410742181336600]%Z) 1 [true; true] [(7, 1)]]);
     (step 13, [Term (- Replay.long [15822439; 419803061875519738; 171829496945035650; 984026794294144943; 417854245505217920]%Z) 1 [] [(0, 1)]; Term (Replay.long [5899894; 526006783891836490; 271516149308106562; 297470799078222493; 323846631487944320]%Z) 1 [true; true] [(0, 1)]; Term (Replay.long [936810; 223304473871563174; 880134366079431609; 417643677637434487; 722362856839680640]%Z) 1 [] [(1, 1)]; Term (- Replay.long [443585; 920199526729341457; 036999793918153774; 035098915021937495; 879730895677664640]%Z) 1 [true; true] [(1, 1)]; Term (- Replay.long [15452391; 262362682567621139; 161396027514818368; 770680262500253282; 495342866371680640]%Z) 1 [] [(3, 1)]; Term (Replay.long [6570056; 237458020909882259; 009949423187349170; 288441895501328137; 556457189915695040]%Z) 1 [true; true] [(3, 1)]; Term (Replay.long [7772991; 158725492440342950; 407757226359234952; 557017403114568105; 962478471509663760]%Z) 1 [] [(6, 1)]; Term (- Replay.long [3214697; 673655713120531547; 708168460724752731; 209098454460202503; 021022345618271360]%Z) 1 [true; true] [(6, 1)]; Term (Replay.long [8643427; 721319076545490133; 654359767125317798; 507568289021312815; 448807468441012000]%Z) 1 [true] [(7, 1)]; Term (- Replay.long [7008196; 516906360787222264; 113448335753097072; 683899854279125454; 231486380688113200]%Z) 1 [false; true] [(7, 1)]]);
     (step 14, [Term 2318757887681066016000 1 [] [(7, 1)]])]
     57101011812477000 [Term (Replay.long [765319068; 335452576010696704; 572008278411001150; 514155984864516927; 500653854742265153; 316233980140002894]%Z) 1 [] []; Term (- Replay.long [312440200; 554930859072026782; 689682307584459465; 996943297989518416; 382576319010765409; 708442351964681761]%Z) 1 [true; true] []];
   (* 16: 1 = 0 *)
   Derive [(step 15, [Term (Replay.long [765319068; 335452576010696704; 572008278411001150; 514155984864516927; 500653854742265153; 316233980140002894]%Z) 1 [] []; Term (Replay.long [312440200; 554930859072026782; 689682307584459465; 996943297989518416; 382576319010765409; 708442351964681761]%Z) 1 [true; true] []])]
     (Replay.long [2821012624; 790619651930097243; 133652236835281073; 838639684836431642; 770945152115199892; 465091538652798378; 524492109478354884; 240759430805959587; 296131422854174574; 678329764378330132; 442290318292008510]%Z) [Term 1 1 [] []]].

Lemma refuted : refuted radicands 4 4 8 36 net 2 1 surface 1 assumptions certificate = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** The weight in row 0, place 0 is a constant, and not zero. *)
Lemma weight : weight_known radicands 4 4 8 36 net 0 0 [Term 1 1 [] []] 36 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

End Data.

(** * 4. The theorem *)

(** For all real values of the unknowns a point of the patch misses the surface. *)
Theorem misses_the_surface : forall X11 Z11 W11 Y12 Z12 W12 Z22 W22 : R,
  exists u v : R, 0 <= u <= 1 /\ 0 <= v <= 1 /\
    patch W (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) u v <> 0 /\ ~ lies_on surface (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) u v.
Proof.
  intros X11 Z11 W11 Y12 Z12 W12 Z22 W22.
  refine (Replay.misses_the_surface Data.radicands eq_refl 4 4 8 36 Data.net 2 1 Data.surface
            1 Data.assumptions Data.certificate Data.refuted
            [X11; Z11; W11; Y12; Z12; W12; Z22; W22] eq_refl _ (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) eq_refl surface (fun _ _ _ _ => eq_refl) _).
  - constructor.
  - exact (Replay.weight_is_known Data.radicands eq_refl _ _ _ _ _ _ _ _ _ _ Data.weight).
Qed.

(** So it is not the case that every point of the patch lies on the surface. *)
Theorem never_on_the_surface : forall X11 Z11 W11 Y12 Z12 W12 Z22 W22 : R,
  ~ (forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 ->
       patch W (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) u v <> 0 -> lies_on surface (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) u v).
Proof.
  intros X11 Z11 W11 Y12 Z12 W12 Z22 W22  always.
  assert (missed : exists u v : R, 0 <= u <= 1 /\ 0 <= v <= 1 /\
    patch W (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) u v <> 0 /\ ~ lies_on surface (net X11 Z11 W11 Y12 Z12 W12 Z22 W22) u v)
    by (eapply misses_the_surface; eassumption).
  destruct missed as [u [v [in_u [in_v [defined missing]]]]].
  exact (missing (always u v in_u in_v defined)).
Qed.

Definition theorems := (misses_the_surface, never_on_the_surface).

Print Assumptions theorems.
