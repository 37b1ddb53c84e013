; lemma: disc
; Whatever a robot does that is at most s0 fast, gains at most A and is never above V, until t <= T:
; it has covered at most S(T) and is at most s1 fast; and S(T) + s1^2 / (2 b) is the most that it
; covers until an ideal brake has stopped it, whenever that takes over. That the way is the integral
; of the speed, which is at most min(V, s0 + A t), is calculus.
; code: compiler/codegen/kernel/motion.c | if (m->accel_mmps2 * t_ms <= (cap - s0) * 1000) {
; code: compiler/codegen/kernel/motion.c | return div_up(s0 * t_ms, 1000) + div_up(m->accel_mmps2 * t_ms * t_ms, 2000000);
; code: compiler/codegen/kernel/motion.c | return div_up(cap * t_ms, 1000) - (cap - s0) * (cap - s0) / (2 * m->accel_mmps2);
; code: compiler/codegen/kernel/motion.c | r.disc_mm = s->p_error_mm + travel_of(s0, t_ms, cap, m) + stop + tube;
; code: compiler/analysis/reach.cpp | return div_up(s.cap_mmps * t_ms, 1000) - rest * rest / (2 * motion.accel_mmps2);

; step: the way with saturation, from gaining speed for r and driving at V from then on
; mistake: s/(\* 0.5 A r r) (\* V (- T r))/(* A r r) (* V (- T r))/
; mistake: s/(assert (= (\* A r) (- V s0)))/(assert (= (* A r) V))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const V Real) (declare-const s0 Real)
(declare-const r Real) (declare-const T Real) (declare-const lost Real)
(assert (> A 0)) (assert (>= V s0))
(assert (= (* A r) (- V s0)))
(assert (= (* 2 A lost) (* (- V s0) (- V s0))))
; claim
(assert (not (= (- (* V T) lost) (+ (* s0 r) (* 0.5 A r r) (* V (- T r))))))
(check-sat)
(reset)

; step: at most s0 fast and saturating at once or later, it covers at least the same in more time
; step+ (S is monotone in T), and is no slower at the end: both do not saturate
; mistake: s/(assert (<= t T))/(assert (<= t (* 2 T)))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const b Real) (declare-const s0 Real)
(declare-const t Real) (declare-const T Real)
(assert (>= A 0)) (assert (> b 0)) (assert (>= s0 0))
(assert (>= t 0)) (assert (<= t T))
; claim
(assert (not (<= (+ (* 2 b (+ (* s0 t) (* 0.5 A t t))) (* (+ s0 (* A t)) (+ s0 (* A t))))
                 (+ (* 2 b (+ (* s0 T) (* 0.5 A T T))) (* (+ s0 (* A T)) (+ s0 (* A T)))))))
(check-sat)
(reset)

; step: it saturates after t
; mistake: s/(assert (<= t T))/(assert (<= t (* 2 T)))/
; mistake: s/(assert (<= (+ s0 (\* A t)) V))//
(set-logic QF_NRA)
(declare-const A Real) (declare-const b Real) (declare-const s0 Real) (declare-const V Real)
(declare-const t Real) (declare-const T Real) (declare-const r Real)
(assert (> A 0)) (assert (> b 0)) (assert (>= s0 0)) (assert (<= s0 V))
(assert (>= t 0)) (assert (<= t T))
(assert (= (* A r) (- V s0)))
(assert (<= (+ s0 (* A t)) V))
(assert (>= T r))
; claim
(assert (not (<= (+ (* 2 b (+ (* s0 t) (* 0.5 A t t))) (* (+ s0 (* A t)) (+ s0 (* A t))))
                 (+ (* 2 b (+ (* s0 r) (* 0.5 A r r) (* V (- T r)))) (* V V)))))
(check-sat)
(reset)

; step: it saturates before t
; mistake: s/(assert (<= t T))/(assert (<= t (* 2 T)))/
(set-logic QF_NRA)
(declare-const b Real) (declare-const V Real) (declare-const lost Real)
(declare-const t Real) (declare-const T Real)
(assert (> b 0)) (assert (>= V 0))
(assert (>= t 0)) (assert (<= t T))
; claim
(assert (not (<= (+ (* 2 b (- (* V t) lost)) (* V V)) (+ (* 2 b (- (* V T) lost)) (* V V)))))
(check-sat)
(reset)

; step: more speed at the start, an error for instance, makes the way no shorter: neither saturates,
; step+ or the faster one alone does, r being when
; mistake: s/(assert (<= s0 f0))/(assert (<= s0 (* 2 f0)))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const V Real) (declare-const s0 Real) (declare-const f0 Real)
(declare-const T Real) (declare-const r Real)
(assert (> A 0)) (assert (>= s0 0)) (assert (<= s0 f0)) (assert (<= f0 V)) (assert (>= T 0))
(assert (<= (+ s0 (* A T)) V))
(assert (= (* A r) (- V f0)))
; claim
(assert (not (<= (+ (* s0 T) (* 0.5 A T T))
                 (ite (>= r T) (+ (* f0 T) (* 0.5 A T T))
                               (+ (* f0 r) (* 0.5 A r r) (* V (- T r)))))))
(check-sat)
(reset)

; step: or both do
; mistake: s/(assert (<= s0 f0))/(assert (<= s0 V))/
(set-logic QF_NRA)
(declare-const A Real) (declare-const V Real) (declare-const s0 Real) (declare-const f0 Real)
(declare-const T Real) (declare-const lost Real) (declare-const f_lost Real)
(assert (> A 0)) (assert (>= s0 0)) (assert (<= s0 f0)) (assert (<= f0 V)) (assert (>= T 0))
(assert (= (* 2 A lost) (* (- V s0) (- V s0))))
(assert (= (* 2 A f_lost) (* (- V f0) (- V f0))))
; claim
(assert (not (<= (- (* V T) lost) (- (* V T) f_lost))))
(check-sat)
(reset)

; step: a place that is in the zone and R and `least` from the boundary, measured with e_p, moves S
; step+ and then stops, in a tube: it keeps `least`
; mistake: s/(+ ep way stop tube least)/(+ ep way tube least)/
; mistake: s/(+ ep way stop tube least)/(+ way stop tube least)/
(set-logic QF_NRA)
(declare-const gap Real) (declare-const ep Real) (declare-const way Real) (declare-const stop Real)
(declare-const tube Real) (declare-const least Real) (declare-const left Real)
(assert (>= ep 0)) (assert (>= way 0)) (assert (>= stop 0)) (assert (>= tube 0))
(assert (>= gap (+ ep way stop tube least)))
(assert (>= left (- gap ep way stop tube)))
; claim
(assert (not (>= left least)))
(check-sat)
(reset)
