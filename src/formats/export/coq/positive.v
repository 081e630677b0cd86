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
