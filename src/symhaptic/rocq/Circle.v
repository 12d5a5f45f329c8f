(* Polynomials with all zeros inside the unit circle. *)
From Symhaptic Require Export Polynomials.
From Coq Require Import Classical.
Open Scope R_scope.

Definition stable (p : C -> C) : Prop := forall z, p z = RtoC 0 -> Cmod z < 1.
Definition hurwitz (p : C -> C) : Prop := forall s, p s = RtoC 0 -> Re s < 0.
Definition outside (z : C) : Prop := 1 <= Cmod z.
Lemma stable_alike : forall p q, (forall z, p z = q z) -> (stable p <-> stable q).
Proof. intros p q E; split; intros H s Z; apply H; [rewrite E | rewrite <- E]; exact Z. Qed.
Lemma stable_free : forall p, stable p <-> free outside p.
Proof.
  intro p; split; intros S z Z.
  - intro E; generalize (S z E); unfold outside in Z; lra.
  - apply Rnot_le_lt; intro L; exact (S z L Z).
Qed.
Lemma distance : forall z w, Rabs (Cmod z - Cmod w) <= Cmod (z - w)%C.
Proof.
  intros z w; apply Rabs_le.
  assert (Cmod z <= Cmod (z - w)%C + Cmod w) by (replace z with ((z - w) + w)%C at 1 by ring; apply Cmod_triangle).
  assert (Cmod w <= Cmod (z - w)%C + Cmod z).
  { replace w with (- (z - w) + z)%C at 1 by ring; rewrite <- (Cmod_opp (z - w)%C); apply Cmod_triangle. }
  lra.
Qed.
Lemma outside_closed : closed outside.
Proof.
  intros z Z; exists (1 - Cmod z); unfold outside in *; split; [lra |]; intros w W V.
  generalize (distance w z) (Rle_abs (Cmod w - Cmod z)); lra.
Qed.
Lemma outside_interior : forall z, 1 < Cmod z -> interior outside z.
Proof.
  intros z Z; exists (Cmod z - 1); unfold outside; split; [lra |]; intros w W.
  generalize (distance w z) (Rle_abs (- (Cmod w - Cmod z))); rewrite Rabs_Ropp; lra.
Qed.
Lemma turned : forall t : R, Cexp (Ci * t)%C = (cos t, sin t).
Proof.
  intro t; rewrite (Cexp_at _ 0 t) by (apply injective_projections; simpl; ring).
  rewrite exp_0; apply injective_projections; simpl; ring.
Qed.
Lemma Cmod_turned : forall t : R, Cmod (Cexp (Ci * t)%C) = 1.
Proof.
  intro t; rewrite turned; unfold Cmod; simpl; transitivity (sqrt 1); [f_equal | apply sqrt_1].
  generalize (pythagoras t); simpl; lra.
Qed.
Lemma Cmod_square : forall z, Cmod z ^ 2 = Re z * Re z + Im z * Im z.
Proof.
  intro z; unfold Cmod; rewrite pow2_sqrt; [unfold Re, Im; ring | apply Rplus_le_le_0_compat; apply pow2_ge_0].
Qed.
(* A point of the circle is 1, at an angle up to PI, or the conjugate of such a point. *)
Lemma on_circle : forall z, Cmod z = 1 ->
  exists t, 0 <= t <= PI /\ (z = Cexp (Ci * t)%C \/ Cconj z = Cexp (Ci * t)%C).
Proof.
  assert (Upper : forall z, Cmod z = 1 -> 0 <= Im z -> exists t, 0 <= t <= PI /\ z = Cexp (Ci * t)%C).
  { intros z M P; exists (Cangle_of z); unfold Cangle_of; destruct (Rle_dec 0 (Im z)) as [L | L]; [| contradiction].
    split; [apply acos_bound |]; rewrite <- (Cexp_log z) at 1.
    - unfold Clog, Cangle_of; rewrite M, ln_1; destruct (Rle_dec 0 (Im z)); [| contradiction].
      f_equal; apply injective_projections; simpl; ring.
    - intro E; rewrite E, Cmod_0 in M; lra. }
  intros z M; destruct (Rle_dec 0 (Im z)) as [L | L].
  - destruct (Upper z M L) as (t & T & E); exists t; split; [exact T | left; exact E].
  - destruct (Upper (Cconj z)) as (t & T & E); [rewrite Cmod_conj; exact M | destruct z; simpl in *; lra |].
    exists t; split; [exact T | right; exact E].
Qed.

(* p(exp(j theta)) = 0: not all zeros lie inside. *)
Theorem zero_on_circle : forall p (t : R), p (Cexp (Ci * t)%C) = RtoC 0 -> ~ stable p.
Proof. intros p t E S; generalize (S _ E); rewrite Cmod_turned; lra. Qed.

(* No zero of f + y g crosses the circle. *)
Lemma stays : forall f g n, monic f n -> below g n -> real_poly f -> real_poly g -> stable f ->
  (forall y t : R, 0 < y <= 1 -> 0 <= t <= PI -> (f (Cexp (Ci * t)) + y * g (Cexp (Ci * t)))%C <> RtoC 0) ->
  stable (fun z => f z + g z)%C.
Proof.
  intros f g n (a & A & F) (b & B & G) Rf Rg S X.
  assert (Al : forall y z, along a b 1 y z = (f z + y * g z)%C) by (intros; unfold along; rewrite F, G; reflexivity).
  apply stable_free; intros z Z E.
  apply (path outside outside_closed a b 1 ltac:(intro K; apply (f_equal fst) in K; simpl in K; lra) ltac:(lia))
    with (z := z); [| | exact Z | rewrite Al, <- E; ring].
  - intros w W V; apply (proj1 (stable_free f) S w W); rewrite <- V, Al; ring.
  - intros y w Y W V; rewrite Al in V; apply outside_interior; destruct W as [W | W]; [exact W | exfalso].
    destruct (on_circle w (eq_sym W)) as (t & T & [D | D]); [rewrite D in V; exact (X y t Y T V) |].
    apply (X y t Y T); rewrite <- D, (real_along f g y Rf Rg), V.
    apply injective_projections; simpl; ring.
Qed.
Theorem roots_stay : forall f g n, monic f n -> below g n -> real_poly f -> real_poly g ->
  (forall y t : R, 0 < y <= 1 -> 0 < t <= PI -> (f (Cexp (Ci * t)) + y * g (Cexp (Ci * t)))%C <> RtoC 0) ->
  (forall y : R, 0 < y <= 1 -> (f 1 + y * g 1)%C <> RtoC 0) -> stable f -> stable (fun z => f z + g z)%C.
Proof.
  intros f g n F G Rf Rg X X1 S; apply (stays f g n); try assumption; intros y t Y [[T | T] U].
  - exact (X y t Y (conj T U)).
  - rewrite <- T, Cexp_nought by ring; exact (X1 y Y).
Qed.
(* The same where the path begins with (z - 1) h: the zero at 1 moves inwards first. *)
Theorem roots_stay_inwards : forall f h g n (u v : R), (forall z, f z = (z - 1) * h z)%C -> monic h n -> below g (S n) ->
  real_poly h -> real_poly g -> h 1%C = RtoC u -> g 1%C = RtoC v ->
  (forall y t : R, 0 < y <= 1 -> 0 < t <= PI -> (f (Cexp (Ci * t)) + y * g (Cexp (Ci * t)))%C <> RtoC 0) ->
  (forall y : R, 0 < y <= 1 -> (f 1 + y * g 1)%C <> RtoC 0) ->
  stable h -> 0 < v -> 0 < u -> stable (fun z => f z + g z)%C.
Proof.
  intros f h g n u v Fh (a & A & H) (b & B & G) Rh Rg U V X X1 S Pv Pu.
  assert (One : RtoC 1 <> RtoC 0) by (intro K; apply (f_equal fst) in K; simpl in K; lra).
  destruct (departs outside 1 a b 1 outside_closed One ltac:(lia)) as (k & K & D).
  { intros z Z E; apply (proj1 (stable_free h) S z Z); rewrite H; exact E. }
  rewrite <- H, <- G, U, V in D.
  set (y := Rmin 1 (Rmin (u / v) (v / (2 * k)))).
  assert (Y : 0 < y <= 1 /\ y * v <= u /\ y * k < v).
  { assert (0 < u / v /\ 0 < v / (2 * k)) as [P Q] by (split; apply Rdiv_lt_0_compat; lra).
    assert (M1 := Rmin_l 1 (Rmin (u / v) (v / (2 * k)))); assert (M2 := Rmin_r 1 (Rmin (u / v) (v / (2 * k)))).
    assert (M3 := Rmin_l (u / v) (v / (2 * k))); assert (M4 := Rmin_r (u / v) (v / (2 * k))).
    repeat split; fold y in M1, M2 |- *.
    - apply Rmin_glb_lt; [lra | apply Rmin_glb_lt; assumption].
    - exact M1.
    - replace u with (u / v * v) by (field; lra); apply Rmult_le_compat_r; lra.
    - assert (y * k <= v / (2 * k) * k) by (apply Rmult_le_compat_r; lra).
      replace (v / (2 * k) * k) with (v / 2) in * by (field; lra); lra. }
  destruct Y as (Y & Yu & Yk).
  assert (Start : stable (fun z => f z + y * g z)%C).
  { intros z E; apply Rnot_le_lt; intro Z; specialize (D y z Y Z).
    rewrite <- H, <- G, <- Fh, E in D; specialize (D eq_refl).
    assert (Q : Cmod (z * u)%C <= Rabs (u - y * v) + k * y ^ 2).
    { replace (z * u)%C with (RtoC (u - y * v) + ((z - 1) * u + y * v))%C by (rewrite RtoC_minus, RtoC_mult; ring).
      eapply Rle_trans; [apply Cmod_triangle |]; rewrite Cmod_R; lra. }
    rewrite Cmod_mult, Cmod_R, (Rabs_pos_eq u), (Rabs_pos_eq (u - y * v)) in Q by lra; simpl in Q; nra. }
  destruct (Req_dec y 1) as [E | E].
  { intros z Ez; apply Start; rewrite E, <- Ez; ring. }
  assert (Fm : monic (fun z => f z + y * g z)%C (Datatypes.S n)).
  { exists (add (add (RtoC 0 :: a) (scale (- RtoC 1)%C (a ++ RtoC 1 :: nil))) (scale y b)).
    rewrite !length_add, !length_scale, app_length; simpl length; split; [lia |]; intro z.
    rewrite poly_app, !length_add, !length_scale, app_length, !poly_add, !poly_scale; simpl length.
    replace (max (max (Datatypes.S (length a)) (length a + 1)) (length b)) with (Datatypes.S (length a)) by lia.
    rewrite Fh, H, G, poly_app; simpl; ring. }
  assert (Gb : below (fun z => RtoC (1 - y) * g z)%C (Datatypes.S n)).
  { exists (scale (RtoC (1 - y)) b); rewrite length_scale; split; [exact B |]; intro z; rewrite poly_scale, G; reflexivity. }
  assert (Rf : real_poly f).
  { intro z; rewrite !Fh, Rh; destruct z, (h (r, r0)); apply injective_projections; simpl; ring. }
  intros z Ez; apply (roots_stay _ _ (Datatypes.S n) Fm Gb) with (z := z).
  - apply real_along; assumption.
  - intro w; rewrite Rg; destruct (g w); apply injective_projections; simpl; ring.
  - intros x t Xp T; replace (f (Cexp (Ci * t)) + y * g (Cexp (Ci * t)) + x * (RtoC (1 - y) * g (Cexp (Ci * t))))%C with
      (f (Cexp (Ci * t)) + RtoC (y + x * (1 - y)) * g (Cexp (Ci * t)))%C by (rewrite RtoC_plus, RtoC_mult; ring).
    apply X; [nra | exact T].
  - intros x Xp; replace (f 1 + y * g 1 + x * (RtoC (1 - y) * g 1))%C with
      (f 1 + RtoC (y + x * (1 - y)) * g 1)%C by (rewrite RtoC_plus, RtoC_mult; ring).
    apply X1; nra.
  - exact Start.
  - rewrite <- Ez, RtoC_minus; ring.
Qed.

(* -- factors of a polynomial with its zeros inside ------------------------------------------ *)

Lemma product_apart_C : forall x y : C, (x * y)%C = RtoC 0 -> x = RtoC 0 \/ y = RtoC 0.
Proof.
  intros x y E; destruct (Ceq_dec x 0) as [F | N]; [left; exact F | right].
  replace y with (x * y / x)%C by (field; exact N); rewrite E; field; exact N.
Qed.
(* The zeros of a product are those of its factors. *)
Theorem all_inside : forall f g, stable f -> stable g -> stable (fun z => f z * g z)%C.
Proof. intros f g F G z E; destruct (product_apart_C _ _ E) as [Z | Z]; [exact (F z Z) | exact (G z Z)]. Qed.
Lemma literal_inside : forall n, stable (fun z => z ^ n)%C.
Proof.
  intros n z E; apply Rnot_le_lt; intro L; assert (K := Cmod_power z n); rewrite E, Cmod_0 in K.
  symmetry in K; revert K; apply pow_nonzero; lra.
Qed.
Lemma power_inside : forall w, stable (fun z => Craised z w).
Proof.
  intros w z E; destruct (Ceq_dec z 0) as [Z | Z]; [rewrite Z, Cmod_0; lra | exfalso; exact (Craised_apart z w Z E)].
Qed.
Lemma within_product : forall p c rs, stable p -> (forall z, p z = c * product rs z)%C -> Forall (fun r : C => Cmod r < 1) rs.
Proof. intros p c rs S F; apply Forall_forall; intros r I; apply S; rewrite F, product_zero by exact I; ring. Qed.
(* The last coefficient is, up to its sign, the leading one times the product of the zeros. *)
Theorem last_coefficient : forall a c, c <> RtoC 0 -> a <> nil -> stable (poly (a ++ c :: nil)) ->
  Cmod (hd (RtoC 0) a) < Cmod c.
Proof.
  intros a c Nc N S; destruct (factors (length a) (a ++ c :: nil)) as (rs & L & F).
  { rewrite app_length; simpl; lia. }
  { rewrite last_last; exact Nc. }
  assert (W := within_product _ _ _ S F); rewrite last_last in F; specialize (F (RtoC 0)).
  replace (hd (RtoC 0) a) with (c * product rs 0)%C.
  2: { rewrite <- F; destruct a; [contradiction | simpl; ring]. }
  assert (Le : forall qs, Forall (fun r : C => Cmod r < 1) qs -> Cmod (product qs 0) <= 1).
  { intros qs Q; induction Q as [| r qs R Q IH]; simpl; [rewrite Cmod_1; lra |]; rewrite Cmod_mult.
    replace (0 - r)%C with (- r)%C by ring; rewrite Cmod_opp.
    generalize (Cmod_ge_0 r) (Cmod_ge_0 (product qs 0)); nra. }
  destruct W as [| r rs R W]; [destruct a; [contradiction | discriminate] |]; simpl; rewrite !Cmod_mult.
  replace (0 - r)%C with (- r)%C by ring; rewrite Cmod_opp.
  assert (P := proj1 (Cmod_gt_0 c) Nc).
  assert (Cmod r * Cmod (product rs 0) < 1) by (generalize (Cmod_ge_0 r) (Cmod_ge_0 (product rs 0)) (Le rs W); nra).
  nra.
Qed.
(* The same of p = z^m f with a real f(0). *)
Theorem last_inside : forall p f n m (c : R), monic f n -> (1 <= n)%nat -> stable p ->
  (forall z, p z = z ^ m * f z)%C -> f 0 = RtoC c -> -1 < c /\ c < 1.
Proof.
  intros p f n m c (a & L & F) N S P E.
  assert (Sf : stable (poly (a ++ RtoC 1 :: nil))) by (intros z Z; apply S; rewrite P, F, Z; ring).
  assert (N1 : RtoC 1 <> RtoC 0) by (apply Cnot_zero; lra).
  assert (A : a <> nil) by (destruct a; [simpl in L; lia | discriminate]).
  assert (B := last_coefficient a _ N1 A Sf); rewrite Cmod_1 in B.
  rewrite F in E; destruct a as [| x a]; [contradiction |]; simpl in B, E.
  replace x with (RtoC c) in B by (rewrite <- E; ring); rewrite Cmod_R in B; apply Rabs_def2 in B; lra.
Qed.
(* The zeros of p(-z) are the opposite ones. *)
Theorem opposite : forall p q s, s <> RtoC 0 -> stable p -> (forall z, q z = s * p (- z))%C -> stable q.
Proof.
  intros p q s N S Q z E; rewrite Q in E; destruct (product_apart_C _ _ E) as [F | F]; [contradiction |].
  rewrite <- Cmod_opp; exact (S _ F).
Qed.

(* -- how fast a polynomial turns on the circle --------------------------------------------- *)

(* Of a product of linear factors with zeros inside, Re z p'/p > n/2 at |z| = 1. *)
Fixpoint turning (rs : list C) (z : C) : C :=
  match rs with nil => RtoC 0 | r :: rs => (z * product rs z + (z - r) * turning rs z)%C end.
Lemma product_turns : forall rs z, Cmod z = 1 -> rs <> nil -> Forall (fun r : C => Cmod r < 1) rs ->
  INR (length rs) * Cmod (product rs z) ^ 2 < 2 * Re (Cconj (product rs z) * turning rs z)%C.
Proof.
  assert (One : forall z r, Cmod z = 1 -> Cmod r < 1 -> Cmod (z - r)%C ^ 2 < 2 * Re (Cconj (z - r) * z)%C).
  { intros z r Z R; assert (A := Cmod_square z); assert (B := Cmod_square r); rewrite Z in A.
    assert (Cmod r ^ 2 < 1) by (generalize (Cmod_ge_0 r); nra).
    rewrite Cmod_square; destruct z, r; unfold Re, Im in *; simpl in *; nra. }
  assert (All : forall rs z, Cmod z = 1 -> Forall (fun r : C => Cmod r < 1) rs ->
    INR (length rs) * Cmod (product rs z) ^ 2 <= 2 * Re (Cconj (product rs z) * turning rs z)%C /\
    (rs <> nil -> INR (length rs) * Cmod (product rs z) ^ 2 < 2 * Re (Cconj (product rs z) * turning rs z)%C)).
  { intros rs z Z W; induction W as [| r rs R W [IH _]]; [simpl; rewrite Cmod_1; split; [lra | contradiction] |].
    assert (P : 0 < Cmod (product rs z) ^ 2).
    { apply pow_lt, Cmod_gt_0; intro E; apply zero_product in E.
      assert (Q := proj1 (Forall_forall _ _) W z E); simpl in Q; lra. }
    assert (D : 0 < Cmod (z - r)%C ^ 2).
    { apply pow_lt, Cmod_gt_0; intro E; assert (F : z = r) by (replace z with (z - r + r)%C by ring; rewrite E; ring).
      rewrite F in Z; lra. }
    specialize (One z r Z R); cbn [length product fold_right turning]; fold (product rs z).
    rewrite S_INR, Cmod_mult.
    replace (Re (Cconj ((z - r) * product rs z) * (z * product rs z + (z - r) * turning rs z))%C) with
      (Cmod (product rs z) ^ 2 * Re (Cconj (z - r) * z)%C + Cmod (z - r)%C ^ 2 * Re (Cconj (product rs z) * turning rs z)%C).
    - set (x := Cmod (product rs z) ^ 2) in *; set (y := Cmod (z - r)%C ^ 2) in *.
      assert (G : (INR (length rs) + 1) * (Cmod (z - r)%C * Cmod (product rs z)) ^ 2 <
        2 * (x * Re (Cconj (z - r) * z)%C + y * Re (Cconj (product rs z) * turning rs z)%C)); [| split; [lra | intros _; exact G]].
      replace ((Cmod (z - r)%C * Cmod (product rs z)) ^ 2) with (y * x) by (unfold x, y; ring).
      assert (y * (INR (length rs) * x) <= y * (2 * Re (Cconj (product rs z) * turning rs z)%C)) by (apply Rmult_le_compat_l; lra).
      assert (x * y < x * (2 * Re (Cconj (z - r) * z)%C)) by (apply Rmult_lt_compat_l; lra).
      lra.
    - rewrite !Cmod_square; destruct (product rs z), (turning rs z), z, r; unfold Re, Im; simpl; ring. }
  intros rs z Z N W; apply (All rs z Z W), N.
Qed.

(* The same of z p', where p is given by its coefficients. *)
Fixpoint slope (a : list C) (z : C) : C :=
  match a with nil => RtoC 0 | _ :: a => (z * (poly a z + slope a z))%C end.
Lemma slope_add : forall a b z, slope (add a b) z = (slope a z + slope b z)%C.
Proof. induction a as [| x a IH]; intros [| y b] z; simpl; try ring; rewrite IH, poly_add; ring. Qed.
Lemma slope_scale : forall c a z, slope (scale c a) z = (c * slope a z)%C.
Proof. intros c a z; induction a as [| x a IH]; simpl; [ring |]; fold (scale c a); rewrite IH, poly_scale; ring. Qed.
Lemma slope_alike : forall a b, (forall z, poly a z = poly b z) -> forall z, slope a z = slope b z.
Proof.
  intros a b E z; assert (V := vanishing (add a (scale (- RtoC 1)%C b))).
  assert (N : forall l, Forall (fun c => c = RtoC 0) l -> poly l z = RtoC 0 /\ slope l z = RtoC 0).
  { intros l F; induction F as [| c l C F [P Q]]; simpl; [split; reflexivity |].
    rewrite C, P, Q; split; ring. }
  destruct (N _ (V ltac:(intro w; rewrite poly_add, poly_scale, E; ring))) as [_ Q].
  rewrite slope_add, slope_scale in Q; replace (slope a z) with (slope a z + - RtoC 1 * slope b z + slope b z)%C by ring.
  rewrite Q; ring.
Qed.
Fixpoint expanded (rs : list C) : list C :=
  match rs with nil => RtoC 1 :: nil | r :: rs => add (scale (- r)%C (expanded rs)) (RtoC 0 :: expanded rs) end.
Lemma poly_expanded : forall rs z, poly (expanded rs) z = product rs z.
Proof. induction rs as [| r rs IH]; intro z; simpl; [ring |]; rewrite poly_add, poly_scale; simpl; rewrite IH; ring. Qed.
Lemma slope_expanded : forall rs z, slope (expanded rs) z = turning rs z.
Proof.
  induction rs as [| r rs IH]; intro z; simpl; [ring |]; rewrite slope_add, slope_scale; simpl.
  rewrite IH, poly_expanded; ring.
Qed.
Theorem outpaces : forall a z, a <> nil -> Cmod z = 1 -> stable (poly (a ++ RtoC 1 :: nil)) ->
  INR (length a) * Cmod (poly (a ++ RtoC 1 :: nil) z) ^ 2 <
    2 * Re (Cconj (poly (a ++ RtoC 1 :: nil) z) * slope (a ++ RtoC 1 :: nil) z)%C.
Proof.
  intros a z N Z S; destruct (factors (length a) (a ++ RtoC 1 :: nil)) as (rs & L & F).
  { rewrite app_length; simpl; lia. }
  { rewrite last_last; intro E; apply (f_equal fst) in E; simpl in E; lra. }
  assert (W := within_product _ _ _ S F); rewrite last_last in F.
  assert (E : forall w, poly (a ++ RtoC 1 :: nil) w = product rs w) by (intro w; rewrite F; ring).
  rewrite E, (slope_alike _ (expanded rs)), slope_expanded, <- L by (intro w; rewrite E, poly_expanded; reflexivity).
  apply product_turns; [exact Z | | exact W]; intro X; rewrite X in L; destruct a; [contradiction | discriminate].
Qed.

Lemma slope_rsum : forall a b z, slope (reals (rsum a b)) z = (slope (reals a) z + slope (reals b) z)%C.
Proof.
  induction a as [| x a IH]; intros [| y b] z; simpl; try ring.
  fold (reals a) (reals b) (reals (rsum a b)); rewrite IH, poly_rsum; ring.
Qed.
Lemma slope_monomial : forall c e z, slope (reals (monomial c e)) z = (RtoC (c * INR e) * z ^ e)%C.
Proof.
  intros c e z; induction e as [| e IH]; [simpl; rewrite Rmult_0_r; ring |].
  change (slope (reals (monomial c (S e))) z) with (z * (poly (reals (monomial c e)) z + slope (reals (monomial c e)) z))%C.
  rewrite IH, poly_monomial, S_INR, !RtoC_mult, RtoC_plus; simpl; ring.
Qed.
(* z p' - n/2 p for a sum of powers. *)
Fixpoint swing (n : R) (s : list (R * nat)) (z : C) : C :=
  match s with nil => RtoC 0 | (c, e) :: s => (RtoC (c * (INR e - n / 2)) * z ^ e + swing n s z)%C end.
Theorem outpaces_powers : forall n s u, degrees_below s n -> (1 <= n)%nat -> Cmod u = 1 ->
  let p := (1, n) :: s in stable (powers p) ->
  Cless 0 (swing (INR n) p u * Cconj (powers p u) + Cconj (swing (INR n) p u) * powers p u)%C.
Proof.
  intros n s u D N U p S; destruct (led 1 n s D) as (a & L & E).
  assert (E' : forall z, powers p z = poly (reals a ++ RtoC 1 :: nil) z).
  { intro z; unfold p; rewrite E; unfold reals; rewrite map_app; reflexivity. }
  assert (O := outpaces (reals a) u); rewrite <- E' in O.
  specialize (O ltac:(intro K; destruct a; [simpl in L; lia | discriminate]) U ltac:(apply (stable_alike _ _ E'), S)).
  assert (W : slope (reals a ++ RtoC 1 :: nil) u = (swing (INR n) p u + INR n / 2 * powers p u)%C).
  { rewrite (slope_alike _ (reals (dense p))) by (intro z; rewrite <- E', poly_dense; reflexivity).
    generalize p; clear; induction p as [| [c e] p IH]; simpl; [ring |].
    rewrite slope_rsum, slope_monomial, IH.
    replace (INR e - INR n / 2) with (INR e + - (INR n / 2)) by ring.
    rewrite !RtoC_mult, RtoC_plus, RtoC_opp, RtoC_div by lra; field. }
  rewrite W in O; unfold reals in O; rewrite map_length, L in O; rewrite Cmod_square in O.
  set (x := swing (INR n) p u) in *; set (y := powers p u) in *; clearbody x y.
  destruct x as [x1 x2], y as [y1 y2]; unfold Cless, Re, Im in *; simpl in *; unfold Rdiv in *.
  repeat split; [ring |]; rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rplus_0_r, ?Rplus_0_l, ?Rminus_0_r in *; nra.
Qed.

(* -- a half plane without a disc --------------------------------------------------------- *)

(* Neither on the imaginary axis nor to its left, nor inside the circle. *)
Definition right_outside (v : C) : Prop := 0 <= Re v /\ 1 <= Cmod v.
Lemma Re_near : forall w v, Rabs (Re w - Re v) <= Cmod (w - v)%C.
Proof.
  intros w v; replace (Re w - Re v) with (Re (w - v)%C) by (destruct w, v; simpl; ring).
  eapply Rle_trans; [apply Rmax_l | apply Rmax_Cmod].
Qed.
Lemma right_outside_closed : closed right_outside.
Proof.
  intros v N; destruct (Rle_dec 0 (Re v)) as [P | P].
  - destruct (outside_closed v) as (e & E & B); [intro O; exact (N (conj P O)) |].
    exists e; split; [exact E |]; intros w W [_ O]; exact (B w W O).
  - exists (- Re v); split; [lra |]; intros w W [Q _]; generalize (Re_near w v) (Rle_abs (Re w - Re v)); lra.
Qed.
Lemma right_outside_interior : forall v, 0 < Re v -> 1 < Cmod v -> interior right_outside v.
Proof.
  intros v P Q; destruct (outside_interior v Q) as (e & E & B); exists (Rmin e (Re v)).
  split; [apply Rmin_glb_lt; assumption |]; intros w W; split.
  - generalize (Re_near w v) (Rle_abs (- (Re w - Re v))) (Rmin_r e (Re v)); rewrite Rabs_Ropp; lra.
  - apply B; generalize (Rmin_l e (Re v)); lra.
Qed.
(* A zero of p(v^2) + y g(v) enters this region over its border only, where there is none. *)
Theorem none_enters : forall p g n, monic (fun v => p (v ^ 2)%C) n -> below g n -> real_poly p -> real_poly g -> stable p ->
  (forall y t : R, 0 < y <= 1 -> 0 < t <= PI / 2 ->
    (p (Cexp (Ci * t) ^ 2) + y * g (Cexp (Ci * t)))%C <> RtoC 0) ->
  (forall y : R, 0 < y <= 1 -> (p 1 + y * g 1)%C <> RtoC 0) ->
  (forall y t : R, 0 < y <= 1 -> 0 < t -> (p ((Ci * exp t) ^ 2) + y * g (Ci * exp t))%C <> RtoC 0) ->
  forall x y : R, 0 < x -> 1 <= x^2 + y^2 -> (p ((x + Ci * y) ^ 2) + g (x + Ci * y))%C <> RtoC 0.
Proof.
  intros p g n (a & A & F) (b & B & G) Rp Rg S Arc One Axis x y X XY E.
  assert (N : RtoC 1 <> RtoC 0) by (intro K; apply (f_equal fst) in K; simpl in K; lra).
  assert (Al : forall y z, along a b 1 y z = (p (z ^ 2) + y * g z)%C).
  { intros; unfold along; rewrite <- F, <- G; reflexivity. }
  assert (Mirror : forall s z, (p (z ^ 2) + RtoC s * g z)%C = RtoC 0 ->
    (p (Cconj z ^ 2) + RtoC s * g (Cconj z))%C = RtoC 0).
  { intros s z Z; replace (Cconj z ^ 2)%C with (Cconj (z ^ 2)%C).
    - rewrite Rp, Rg; transitivity (Cconj (p (z ^ 2) + RtoC s * g z)%C); [| rewrite Z];
        [destruct (p (z ^ 2)%C), (g z) |]; apply injective_projections; simpl; ring.
    - destruct z; apply injective_projections; simpl; ring. }
  (* on the upper part of the border *)
  assert (Border : forall s z, 0 < s <= 1 -> 0 <= Im z -> (Re z = 0 /\ 1 < Cmod z) \/ (0 <= Re z /\ Cmod z = 1) ->
    (p (z ^ 2) + RtoC s * g z)%C <> RtoC 0).
  { intros s z Sp P [[R0 M] | [R0 M]] Z.
    - assert (Q : 1 < Im z).
      { destruct z as [u v]; unfold Cmod in M; simpl in *; rewrite R0 in M.
        replace (0 * (0 * 1) + v * (v * 1)) with (v * v) in M by ring; rewrite sqrt_square in M; lra. }
      apply (Axis s (ln (Im z)) Sp); [rewrite <- ln_1; apply ln_increasing; lra |]; rewrite exp_ln by lra.
      replace (Ci * RtoC (Im z))%C with z; [exact Z |]; destruct z; simpl in *; apply injective_projections; simpl; lra.
    - destruct (on_circle z M) as (t & T & D).
      assert (Zt : z = Cexp (Ci * t)%C).
      { destruct D as [D | D]; [exact D |].
        assert (I : Im z = - sin t) by (rewrite turned in D; apply (f_equal snd) in D; destruct z; simpl in *; lra).
        assert (0 <= sin t) by (apply sin_ge_0; lra).
        assert (Z0 : Im z = 0) by lra.
        rewrite <- D; destruct z; simpl in *; apply injective_projections; simpl; lra. }
      assert (Ct : Re z = cos t) by (rewrite Zt, turned; reflexivity).
      assert (t <= PI / 2).
      { apply Rnot_lt_le; intro L; assert (cos t < 0) by (apply cos_lt_0; lra); lra. }
      rewrite Zt in Z; destruct T as [[T | T] U]; [exact (Arc s t Sp ltac:(lra) Z) |].
      rewrite <- T, Cexp_nought in Z by ring; apply (One s Sp); rewrite <- Z; do 2 f_equal; simpl; ring. }
  assert (V : right_outside (x + Ci * y)%C).
  { split; [simpl; lra |]; unfold Cmod; simpl; apply Rle_trans with (sqrt 1); [rewrite sqrt_1; lra | apply sqrt_le_1_alt].
    replace ((x + (0 * y - 1 * 0)) * ((x + (0 * y - 1 * 0)) * 1) + (0 + (0 * 0 + 1 * y)) * ((0 + (0 * 0 + 1 * y)) * 1))
      with (x ^ 2 + y ^ 2) by ring; exact XY. }
  apply (path right_outside right_outside_closed a b 1 N ltac:(lia)) with (z := (x + Ci * y)%C);
    [| | exact V | rewrite Al, <- E; ring].
  - intros w [_ W] Z; rewrite Al in Z; assert (L := S (w ^ 2)%C ltac:(rewrite <- Z; ring)).
    rewrite Cmod_power in L; nra.
  - intros s w Sp W Z; rewrite Al in Z; destruct W as [P Q].
    assert (Inner : 0 < Re w /\ 1 < Cmod w); [| apply right_outside_interior; apply Inner].
    assert (NB : ~ ((Re w = 0 /\ 1 < Cmod w) \/ (0 <= Re w /\ Cmod w = 1))).
    { intro H; destruct (Rle_dec 0 (Im w)) as [I | I]; [exact (Border s w Sp I H Z) |].
      apply (Border s (Cconj w) Sp); [destruct w; simpl in *; lra | | exact (Mirror s w Z)].
      rewrite Cmod_conj; destruct w; exact H. }
    destruct (Req_dec (Cmod w) 1), (Req_dec (Re w) 0); split; try lra; exfalso; apply NB; first [right; split; lra | left; split; lra].
Qed.

(* -- Schur's criterion --------------------------------------------------------------------- *)

(* p_star(z) = z^n conj(p(1/conj z)) has the conjugate coefficients in the opposite order. *)
Definition star (n : nat) (p : C -> C) (z : C) : C := (z ^ n * Cconj (p (/ Cconj z)))%C.
Lemma star_star : forall n p z, z <> RtoC 0 -> star n (star n p) z = p z.
Proof.
  intros n p z N; assert (M := conj_apart z N); unfold star.
  rewrite conj_mult, conj_conj, conj_power, conj_inverse by exact N.
  assert (V : (/ / z)%C = z) by (field; exact N); rewrite V; transitivity ((z * / z) ^ n * p z)%C; [rewrite Cpower_product; ring |].
  rewrite Cinv_r, Cpower_one by exact N; ring.
Qed.
Lemma poly_star : forall a x z, z <> RtoC 0 ->
  poly (map Cconj (rev (x :: a))) z = star (length a) (poly (x :: a)) z.
Proof.
  intros a x z N; assert (M := conj_apart z N); unfold star; revert x; induction a as [| y a IH]; intro x.
  - simpl; rewrite conj_plus; apply injective_projections; simpl; ring.
  - change (rev (x :: y :: a)) with (rev (y :: a) ++ x :: nil); rewrite map_app, poly_app, map_length, rev_length, IH.
    change (poly (x :: y :: a) (/ Cconj z)%C) with (x + / Cconj z * poly (y :: a) (/ Cconj z))%C.
    rewrite conj_plus, conj_mult, conj_inverse by exact N; simpl length; simpl Cpower; simpl map; simpl (poly (_ :: nil)).
    cbn [poly]; field; exact N.
Qed.
(* If all zeros of p lie inside, |p_star| <= |p| outside. *)
Lemma star_size : forall a c z, c <> RtoC 0 -> stable (poly (a ++ c :: nil)) -> 1 <= Cmod z ->
  Cmod (star (length a) (poly (a ++ c :: nil)) z) <= Cmod (poly (a ++ c :: nil) z).
Proof.
  intros a c z N S Z; assert (Nz : z <> RtoC 0) by (intro E; rewrite E, Cmod_0 in Z; lra).
  destruct (factors (length a) (a ++ c :: nil)) as (rs & L & F).
  { rewrite app_length; simpl; lia. }
  { rewrite last_last; exact N. }
  assert (W := within_product _ _ _ S F); rewrite last_last in F; unfold star.
  rewrite !F, conj_mult, <- L; replace (z ^ length rs * (Cconj c * Cconj (product rs (/ Cconj z))))%C with
    (Cconj c * (z ^ length rs * Cconj (product rs (/ Cconj z))))%C by ring.
  rewrite Cmod_mult, (Cmod_mult c), Cmod_conj; apply Rmult_le_compat_l; [apply Cmod_ge_0 |]; clear F L S.
  induction W as [| r rs R W IH]; simpl.
  - apply Req_le; f_equal; apply injective_projections; simpl; ring.
  - rewrite conj_mult, conj_minus, conj_inverse by exact Nz.
    replace (z * z ^ length rs * ((/ z - Cconj r) * Cconj (product rs (/ Cconj z))))%C with
      ((1 - z * Cconj r) * (z ^ length rs * Cconj (product rs (/ Cconj z))))%C by (field; exact Nz).
    rewrite (Cmod_mult (1 - z * Cconj r)%C), (Cmod_mult (z - r)%C).
    apply Rmult_le_compat; [apply Cmod_ge_0 | apply Cmod_ge_0 | | exact IH].
    assert (Q := Cmod_square z); assert (P := Cmod_square r); assert (Pr := Cmod_ge_0 r).
    apply Rsqr_incr_0_var; [| apply Cmod_ge_0]; unfold Rsqr.
    replace (Cmod (1 - z * Cconj r)%C * Cmod (1 - z * Cconj r)%C) with (Cmod (1 - z * Cconj r)%C ^ 2) by ring.
    replace (Cmod (z - r)%C * Cmod (z - r)%C) with (Cmod (1 - z * Cconj r)%C ^ 2 + (Cmod z ^ 2 - 1) * (1 - Cmod r ^ 2)).
    + assert (0 <= (Cmod z ^ 2 - 1) * (1 - Cmod r ^ 2)) by (apply Rmult_le_pos; simpl; nra); lra.
    + transitivity (Cmod (z - r)%C ^ 2); [| ring]; rewrite !Cmod_square; destruct z, r; unfold Re, Im; simpl; ring.
Qed.

(* (p - p(0)/conj(b) p_star)/z, where b leads p. *)
Definition reduced (a : list C) : list C :=
  let k := (hd (RtoC 0) a / Cconj (last a (RtoC 0)))%C in
  tl (map (fun x => (fst x - k * Cconj (snd x))%C) (combine a (rev a))).
Lemma poly_combined : forall k a b z, length a = length b ->
  poly (map (fun x => (fst x - k * Cconj (snd x))%C) (combine a b)) z = (poly a z - k * poly (map Cconj b) z)%C.
Proof.
  intros k a; induction a as [| x a IH]; intros [| y b] z L; simpl in *; try lia; [ring |].
  rewrite IH by lia; ring.
Qed.
Lemma poly_reduced : forall x a c z, c <> RtoC 0 -> z <> RtoC 0 ->
  (z * poly (reduced (x :: a ++ c :: nil)) z =
    poly (x :: a ++ c :: nil) z - x / Cconj c * star (S (length a)) (poly (x :: a ++ c :: nil)) z)%C.
Proof.
  intros x a c z N Z; assert (M := conj_apart c N); set (k := (x / Cconj c)%C).
  replace (S (length a)) with (length (a ++ c :: nil)) by (rewrite app_length; simpl; lia).
  rewrite <- poly_star, <- poly_combined by (rewrite ?rev_length; auto); unfold reduced.
  assert (La : last (x :: a ++ c :: nil) (RtoC 0) = c) by exact (last_last (x :: a) c (RtoC 0)).
  assert (Rv : rev (x :: a ++ c :: nil) = c :: rev (x :: a)) by exact (rev_app_distr (x :: a) (c :: nil)).
  rewrite La, Rv; simpl hd; fold k; simpl; replace (x - k * Cconj c)%C with (RtoC 0) by (unfold k; field; exact M); ring.
Qed.
Lemma combine_end : forall (a b : list C) x y, length a = length b ->
  combine (a ++ x :: nil) (b ++ y :: nil) = combine a b ++ (x, y) :: nil.
Proof.
  induction a as [| u a IH]; intros [| v b] x y L; simpl in *; try lia; [reflexivity |].
  rewrite IH by lia; reflexivity.
Qed.
Lemma reduced_end : forall x a c, exists b, length b = length a /\
  reduced (x :: a ++ c :: nil) = b ++ (c - x / Cconj c * Cconj x)%C :: nil.
Proof.
  intros x a c; unfold reduced.
  assert (La : last (x :: a ++ c :: nil) (RtoC 0) = c) by exact (last_last (x :: a) c (RtoC 0)).
  assert (Rv : rev (x :: a ++ c :: nil) = c :: rev a ++ x :: nil) by exact (rev_app_distr (x :: a) (c :: nil)).
  rewrite La, Rv; simpl; rewrite combine_end, map_app by (rewrite rev_length; reflexivity).
  eexists; split; [| simpl; reflexivity]; rewrite map_length, combine_length, rev_length; lia.
Qed.
Theorem schur : forall a : list C, last a (RtoC 0) <> RtoC 0 ->
  (stable (poly a) <->
    length a = 1%nat \/ (Cmod (hd (RtoC 0) a) < Cmod (last a (RtoC 0)) /\ stable (poly (reduced a)))).
Proof.
  intros a N; destruct a as [| x a] using rev_ind; [contradiction |]; clear IHa; rename x into c.
  rewrite last_last in *; destruct a as [| x a]; simpl hd; simpl app.
  { split; [left; reflexivity |]; intros _ z E; exfalso; apply N; simpl in E; rewrite <- E; ring. }
  set (f := x :: a ++ c :: nil); set (k := (x / Cconj c)%C); set (n := S (length a)).
  assert (M := conj_apart c N); assert (P := proj1 (Cmod_gt_0 c) N).
  assert (K : Cmod k * Cmod c = Cmod x) by (unfold k; rewrite Cmod_div, Cmod_conj by exact M; field; lra).
  assert (Red : forall z, z <> RtoC 0 -> (z * poly (reduced f) z = poly f z - k * star n (poly f) z)%C).
  { intros z Z; exact (poly_reduced x a c z N Z). }
  assert (Nz : forall z, 1 <= Cmod z -> z <> RtoC 0) by (intros z Z E; rewrite E, Cmod_0 in Z; lra).
  split.
  - intro S; right; assert (Lt : Cmod x < Cmod c) by exact (last_coefficient (x :: a) c N ltac:(discriminate) S).
    split; [exact Lt |]; intros z E; apply Rnot_le_lt; intro Z; specialize (Red z (Nz z Z)); rewrite E in Red.
    assert (B : Cmod (star n (poly f) z) <= Cmod (poly f z)) by exact (star_size (x :: a) c z N S Z).
    assert (V : poly f z = (k * star n (poly f) z)%C).
    { replace (poly f z) with (poly f z - k * star n (poly f) z + k * star n (poly f) z)%C by ring; rewrite <- Red; ring. }
    assert (Zero : Cmod (poly f z) = 0).
    { apply (f_equal Cmod) in V; rewrite Cmod_mult in V; assert (Cmod k < 1) by nra.
      generalize (Cmod_ge_0 k) (Cmod_ge_0 (star n (poly f) z)); nra. }
    apply Cmod_eq_0 in Zero; generalize (S z Zero); lra.
  - intros [E | [Lt S]]; [simpl in E; rewrite app_length in E; simpl in E; lia |]; intros z E; apply Rnot_le_lt; intro Z.
    destruct (reduced_end x a c) as (b & L & R); fold f k in R; rewrite R in *.
    assert (Nc : (c - k * Cconj x)%C <> RtoC 0).
    { intro Q; assert (D : c = (k * Cconj x)%C) by (replace c with (c - k * Cconj x + k * Cconj x)%C by ring; rewrite Q; ring).
      apply (f_equal Cmod) in D; rewrite Cmod_mult, Cmod_conj in D; generalize (Cmod_ge_0 k); nra. }
    assert (B := star_size b _ z Nc S Z); set (g := poly (b ++ _ :: nil)) in *.
    assert (Star : star n (poly f) z = star (length b) g z).
    { (* where p vanishes, the star of p is that of the reduced polynomial *)
      assert (Zn := Nz z Z); assert (Cz := conj_apart z Zn); set (w := (/ Cconj z)%C).
      assert (Cw : Cconj w = (/ z)%C) by exact (conj_inverse z Zn).
      assert (Wn : w <> RtoC 0) by (intro Q; apply Cz; rewrite <- (Cmult_1_r (Cconj z)), <- (Cinv_r _ Cz); fold w; rewrite Q; ring).
      assert (Fw : poly f w = (w * g w)%C).
      { rewrite Red by exact Wn; replace (star n (poly f) w) with (RtoC 0); [ring |].
        unfold star; rewrite Cw; replace (/ / z)%C with z by (field; exact Zn); rewrite E.
        apply injective_projections; simpl; ring. }
      unfold star; fold w; rewrite Fw, conj_mult, Cw; unfold n; rewrite L; simpl; field; exact Zn. }
    specialize (Red z (Nz z Z)); rewrite E, Star in Red; apply (f_equal Cmod) in Red.
    replace (0 - k * star (length b) g z)%C with (- (k * star (length b) g z))%C in Red by ring.
    rewrite Cmod_opp, !Cmod_mult in Red; assert (Zero : Cmod (g z) = 0).
    { assert (Cmod k < 1) by nra; generalize (Cmod_ge_0 k) (Cmod_ge_0 (g z)) (Cmod_ge_0 (star (length b) g z)); nra. }
    apply Cmod_eq_0 in Zero; generalize (S z Zero); lra.
Qed.

