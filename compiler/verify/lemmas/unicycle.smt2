; lemma: unicycle
; The axle's centre of a unicycle as a point mass: an acceleration of at most sqrt(A^2 + (V W)^2); and
; the bend of its stop while the turn rate runs down from W by at least a: at most W^2 / a of the
; stopping distance, and never more than twice that.
; code: compiler/analysis/limits.cpp | return root_up(accel * accel + lateral * lateral);
; code: compiler/analysis/limits.cpp | Rational(kind.motion.turn->value * kind.motion.turn->value / kind.motion.turn_accel->value)
; code: compiler/codegen/kernel/motion.c | div_up(stop * b->brake_lag_permille, 1000) + b->hold_mm;

; step: the acceleration, along the way and across it (speed times turn rate)
; mistake: s/(assert (<= (\* turn turn) (\* W W)))//
; mistake: s/(+ (\* A A) (\* V V W W))/(* V V W W)/
(set-logic QF_NRA)
(declare-const speed Real) (declare-const turn Real) (declare-const gain Real)
(declare-const A Real) (declare-const V Real) (declare-const W Real)
(assert (>= A 0)) (assert (>= V 0)) (assert (>= W 0))
(assert (<= (* speed speed) (* V V))) (assert (<= (* turn turn) (* W W)))
(assert (<= (* gain gain) (* A A)))
; claim
(assert (not (<= (+ (* gain gain) (* speed speed turn turn)) (+ (* A A) (* V V W W)))))
(check-sat)
(reset)

; step: until the turn rate, W - a t at most, is 0, it turns by W^2 / (2 a)
; mistake: s/(assert (= (\* 2 a turned) (\* W W)))/(assert (= (* 3 a turned) (* W W)))/
(set-logic QF_NRA)
(declare-const W Real) (declare-const a Real) (declare-const t Real) (declare-const turned Real)
(declare-const so_far Real)
(assert (> a 0)) (assert (>= W 0)) (assert (>= t 0)) (assert (<= (* a t) W))
(assert (= so_far (- (* W t) (* 0.5 a t t))))
(assert (= (* 2 a turned) (* W W)))
; claim
(assert (not (<= so_far turned)))
(check-sat)
(reset)

; step: directions of unit length that are the angle `turned` apart are no farther apart than that
; step+ (the chord of an arc) and than 2; over a way of the length l the places are l times as far
; mistake: s/(\* l share)/(* 0.4 l share)/
(set-logic QF_NRA)
(declare-const l Real) (declare-const turned Real) (declare-const apart Real)
(declare-const off Real) (declare-const share Real)
(assert (>= l 0)) (assert (>= turned 0)) (assert (>= apart 0))
(assert (<= apart turned)) (assert (<= apart 2))
(assert (<= off (* l apart)))
(assert (= share (ite (<= (* 2 turned) 2) (* 2 turned) 2)))
; claim
(assert (not (<= off (* l share))))
(check-sat)
(reset)

; step: the straight stop holds the place at the same length of way
; mistake: s/(assert (<= n s))//
(set-logic QF_NRA)
(declare-const b Real) (declare-const n Real) (declare-const s Real) (declare-const covered Real)
(assert (> b 0)) (assert (<= 0 n)) (assert (<= n s))
(assert (= (* 2 b covered) (- (* s s) (* n n))))
; claim
(assert (not (and (<= 0 covered) (<= (* 2 b covered) (* s s)))))
(check-sat)
(reset)
