; lemma: command_stops
; Where the recovery takes over at t, the robot stops at sigma(t) = c(t) + w(t)|w(t)| / (2 b). Between
; two stops sigma is off their straight line by |u| h^2 / 8 (command_legs), by gained^2 / (8 b), and
; where the speed saturates by V off / b; and what lies between the ways to two stops is within twice
; what the four places are off one line of these ways or the line between the stops.
; code: compiler/codegen/kernel/command.c | div_up(gained * h_us, 8000000) + div_up(gained * gained, 8 * w->brake_umps2) + div_up(cap * off, w->brake_umps2));
; code: compiler/codegen/kernel/command.c | return 2 * div_up(max_of(magnitude(cross(d, e)), magnitude(cross(d, f))), length);

; step: the second derivative of w|w| under a constant command of the length m, whose component along
; step+ w has the part c of it: (m (1 + c^2), 2 m c s) m in axes along w. It is at most 2 m^2 long; a curve
; step+ whose second derivative is 2 m^2 / (2 b) is within h^2 / 8 of that of its chord (interpolation)
; mistake: s/(\* 4 m m m m)/(* 3 m m m m)/
(set-logic QF_NRA)
(declare-const m Real) (declare-const c Real) (declare-const s Real)
(declare-const x Real) (declare-const y Real)
(assert (>= m 0)) (assert (= (+ (* c c) (* s s)) 1))
(assert (= x (* m m (+ 1 (* c c))))) (assert (= y (* 2 m m c s)))
; claim
(assert (not (<= (+ (* x x) (* y y)) (* 4 m m m m))))
(check-sat)
(reset)

; step: that derivative: of f = w n, n = |w|, with n' = (w u) / n, in axes along w = (n, 0), u = (g, k):
; step+ f'' = 2 u n' + w n'', n'' = (m^2 - n'^2) / n
; mistake: s/(\* 2 g g) (\* n second)/(* g g) (* n second)/
(set-logic QF_NRA)
(declare-const n Real) (declare-const g Real) (declare-const k Real) (declare-const second Real)
(declare-const x Real) (declare-const y Real)
(assert (> n 0)) (assert (= (* n second) (- (+ (* g g) (* k k)) (* g g))))
(assert (= x (+ (* 2 g g) (* n second)))) (assert (= y (* 2 k g)))
; claim
(assert (not (and (= x (+ (* g g) (+ (* g g) (* k k)))) (= y (* 2 g k)))))
(check-sat)
(reset)

; step: gained^2 / (8 b) with gained = m h
; mistake: s/(\* 8 off) (\* h h curve)/(* 4 off) (* h h curve)/
(set-logic QF_NRA)
(declare-const m Real) (declare-const h Real) (declare-const b Real) (declare-const off Real)
(declare-const curve Real) (declare-const gained Real)
(assert (> b 0)) (assert (>= m 0)) (assert (>= h 0)) (assert (= gained (* m h)))
(assert (<= (* 2 b curve) (* 2 m m))) (assert (<= (* 8 off) (* h h curve)))
; claim
(assert (not (<= (* 8 b off) (* gained gained))))
(check-sat)
(reset)

; step: with a velocity of at most V that is off by `off`, the stop is off by V off / b
; step+ (stop_difference)
; mistake: s/(assert (<= n V))/(assert (<= n (* 2 V)))/
(set-logic QF_NRA)
(declare-const V Real) (declare-const m Real) (declare-const n Real) (declare-const off Real)
(declare-const b Real) (declare-const stop Real)
(assert (> b 0)) (assert (>= off 0)) (assert (>= m 0)) (assert (>= n 0))
(assert (<= m V)) (assert (<= n V))
(assert (<= (* 2 b stop) (* (+ m n) off)))
; claim
(assert (not (<= (* b stop) (* V off))))
(check-sat)
(reset)

; step: in the strip around the line between two places, a place and that of a curve through the strip
; step+ at the same length along it are twice the width apart at most
; mistake: s/(assert (<= (- width) curve))//
(set-logic QF_NRA)
(declare-const width Real) (declare-const place Real) (declare-const curve Real)
(assert (<= (- width) place)) (assert (<= place width))
(assert (<= (- width) curve)) (assert (<= curve width))
; claim
(assert (not (and (<= (- place curve) (* 2 width)) (<= (- curve place) (* 2 width)))))
(check-sat)
(reset)
