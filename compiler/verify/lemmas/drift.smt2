; lemma: drift
; Under any acceleration of at most A, velocity and place are within A t and A t^2 / 2 of those of
; straight motion, and with the errors of the measurement within e_v + A t and e_p + e_v t +
; A t^2 / 2. Shown for accelerations that are constant piece by piece, by induction over the pieces;
; every measurable one is a limit of such.
; code: compiler/codegen/kernel/motion.c | const int64_t drift = s->v_error_mmps + div_up(m->accel_mmps2 * t_ms, 1000);
; code: compiler/codegen/kernel/motion.c | const int64_t by_error = div_up(s->v_error_mmps * t_ms, 1000);
; code: compiler/codegen/kernel/motion.c | const int64_t by_accel = div_up(m->accel_mmps2 * t_ms * t_ms, 2000000);

; step: a piece of length h with the acceleration q, after a time t: the velocity; triangle
; mistake: s/(\* A (+ t h))/(* A t)/
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const h Real)
(declare-const w Real) (declare-const q Real) (declare-const after Real)
(assert (>= A 0)) (assert (>= t 0)) (assert (>= h 0))
(assert (<= w (* A t))) (assert (<= q A))
(assert (<= after (+ w (* q h))))
; claim
(assert (not (<= after (* A (+ t h)))))
(check-sat)
(reset)

; step: and the place
; mistake: s/(\* w h) (\* q h h 0.5)/(* w h) (* q h h)/
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const h Real)
(declare-const x Real) (declare-const w Real) (declare-const q Real) (declare-const after Real)
(assert (>= A 0)) (assert (>= t 0)) (assert (>= h 0))
(assert (<= x (* A t t 0.5))) (assert (<= w (* A t))) (assert (<= q A))
(assert (<= after (+ x (* w h) (* q h h 0.5))))
; claim
(assert (not (<= after (* A (+ t h) (+ t h) 0.5))))
(check-sat)
(reset)

; step: with the errors of the measurement: what holds at t is at most what the bound is at T
; mistake: s/(\* ev T) (\* 0.5 A T T)/(* 0.5 A T T)/
; mistake: s/(assert (<= t T))/(assert (<= t (+ T 1)))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const t Real) (declare-const T Real)
(declare-const ep Real) (declare-const ev Real) (declare-const off Real)
(assert (>= A 0)) (assert (>= ep 0)) (assert (>= ev 0))
(assert (>= t 0)) (assert (<= t T))
(assert (<= off (+ ep (* ev t) (* 0.5 A t t))))
; claim
(assert (not (<= off (+ ep (* ev T) (* 0.5 A T T)))))
(check-sat)
(reset)
