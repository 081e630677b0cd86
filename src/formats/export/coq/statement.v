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
