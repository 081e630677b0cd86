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
