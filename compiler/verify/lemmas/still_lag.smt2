; lemma: still_lag
; How long the sampled brake takes from the speed s until the robot is never faster than R =
; eta b / (b - d) again: at most s / (b - d) + 2 b eta / (b - d)^2, and undisturbed s / b + eta / b.
; Units, and x, v, q as in sampled_brake; the time is at most theta(s) - theta(R) for every theta whose
; rate outweighs that of time: theta' (c - d) >= 1. That it is never faster again is sampled_brake.
; code: compiler/ir/module.h | if (b.disturbance_mmps2 == 0) return b.brake_late_ms;
; code: compiler/ir/module.h | return (b.brake_late_ms * 2 * (1000 + sway_permille(b)) + 999) / 1000;
; code: compiler/analysis/limits.cpp | b.stands_mmps = std::max(div_up(b.brake_late_ms * b.brake_mmps2, 1000) + b.velocity_error_mmps,
; code: compiler/codegen/kernel/motion.c | div_up(horizon_us, 1000) + div_up(1000 * s1, b->net_brake_mmps2) + b->still_lag_ms;

; step: above R the angle takes 1/v^2 at most of the brake, v^2 <= x^2 + 1
; mistake: s/(\* 2 v x q)/(* v x q)/
(set-logic QF_NRA)
(declare-const v Real) (declare-const x Real) (declare-const q Real)
(assert (>= x 1)) (assert (>= v x)) (assert (<= (* v v) (+ (* x x) 1)))
(assert (>= q 0)) (assert (<= (* 2 v x q) (- 1 (* (- x v) (- x v)))))
; claim
(assert (not (<= (* v v q) 1)))
(check-sat)
(reset)

; step: and beyond
; mistake: s/(>= (\* v v (- 1 q) (- 1 q)) (- (\* v v) 1))/(>= (* v v (- 1 q) (- 1 q)) (- (* v v) 2))/
(set-logic QF_NRA)
(declare-const v Real) (declare-const q Real)
(assert (>= v 1)) (assert (>= q 0)) (assert (<= q 1))
(assert (>= (* v v (- 1 q) (- 1 q)) (- (* v v) 1)))
; claim
(assert (not (<= (* v v q) 1)))
(check-sat)
(reset)

; step: theta = x v - 2 x^2 / v does it, where at least half of b - d is left of the brake
; mistake: s/(+ (\* x v v) (\* 2 x x))/(+ (* x v v) (* 0.5 x x))/
(set-logic QF_NRA)
(declare-const v Real) (declare-const x Real) (declare-const q Real)
(assert (>= x 1)) (assert (>= v x))
(assert (>= q 0)) (assert (<= (* v v q) 1)) (assert (<= (* 2 x q) 1))
; claim
(assert (not (>= (* (+ (* x v v) (* 2 x x)) (- 1 (* x q))) (* x v v))))
(check-sat)
(reset)

; step: half is left: near R
; mistake: s/(assert (>= v x))/(assert (>= v (* 0.5 x)))/
(set-logic QF_NRA)
(declare-const v Real) (declare-const x Real) (declare-const q Real)
(assert (>= x 1)) (assert (>= v x)) (assert (<= (* v v) (+ (* x x) 1)))
(assert (>= q 0)) (assert (<= (* 2 v x q) (- 1 (* (- x v) (- x v)))))
; claim
(assert (not (<= (* 2 x q) 1)))
(check-sat)
(reset)

; step: and beyond
; mistake: s/(assert (>= (\* v v) (+ (\* x x) 1)))/(assert (>= (* v v) (* x 0.5)))/
(set-logic QF_NRA)
(declare-const v Real) (declare-const x Real) (declare-const q Real)
(assert (>= x 1)) (assert (>= v 1)) (assert (>= (* v v) (+ (* x x) 1)))
(assert (>= q 0)) (assert (<= q 1))
(assert (>= (* v v (- 1 q) (- 1 q)) (- (* v v) 1)))
; claim
(assert (not (<= (* 2 x q) 1)))
(check-sat)
(reset)

; step: theta(s) - theta(x) is at most x s + 2 x^2
; mistake: s/(+ (\* x s) (\* 2 x x))/(* x s)/
(set-logic QF_NRA)
(declare-const x Real) (declare-const s Real) (declare-const spent Real)
(assert (>= x 1)) (assert (>= s x))
(assert (= (* s spent) (- (* s (+ (* x s) (* (- x) x) (* 2 x))) (* 2 x x))))
; claim
(assert (not (<= spent (+ (* x s) (* 2 x x)))))
(check-sat)
(reset)

; step: undisturbed, x = 1: from s >= 1, the square root r of 1 - 1/v^2 or, up to v^2 = 2, v / 2 is
; step+ left of the brake. The time is sqrt(s^2 - 1) - 1 + log 2, log 2 <= 0.6932, which is at most s
; mistake: s/(- 0.6932 1)/(+ 0.6932 1)/
(set-logic QF_NRA)
(declare-const s Real) (declare-const root Real) (declare-const spent Real)
(assert (>= (* s s) 2)) (assert (> s 0)) (assert (>= root 0)) (assert (= (* root root) (- (* s s) 1)))
(assert (= spent (+ root (- 0.6932 1))))
; claim
(assert (not (<= spent s)))
(check-sat)
(reset)

; step: and up to s^2 = 2 it is 2 log s, at most 2 (s - 1)
; mistake: s/(\* 2 (- s 1))/(* 5 s)/
(set-logic QF_NRA)
(declare-const s Real) (declare-const spent Real)
(assert (>= s 1)) (assert (<= (* s s) 2)) (assert (<= spent (* 2 (- s 1))))
; claim
(assert (not (<= spent (+ s 1))))
(check-sat)
(reset)
