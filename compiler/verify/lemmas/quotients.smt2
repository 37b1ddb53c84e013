; lemma: quotients
; One-sided rounding of what the kernel divides. Demands round up, supplies down; a sum of numbers that
; are rounded up is not below the number itself, and nor is a product of such, of numbers from 0 on.
; code: compiler/codegen/kernel/arith.c | return (a + b - 1) / b;
; code: compiler/analysis/reach.cpp | return (a + b - 1) / b;

; step: div_up: the quotient of a + b - 1, rounded towards 0, is the smallest number not below a / b
; mistake: s/(- (+ a b) 1)/a/
; mistake: s/(- (+ a b) 1)/(+ a b)/
(set-logic QF_NIA)
(declare-const a Int) (declare-const b Int) (declare-const q Int) (declare-const r Int)
(assert (>= a 0)) (assert (> b 0))
(assert (= (- (+ a b) 1) (+ (* q b) r))) (assert (<= 0 r)) (assert (< r b)) (assert (>= q 0))
; claim
(assert (not (and (>= (* q b) a) (< (* (- q 1) b) a))))
(check-sat)
(reset)

; step: A t^2 / 2 with a time in ms that is rounded up: A div_up(t)^2 / 2 div_up again is not below
; mistake: s/(assert (>= (\* 1000 ms) us))//
(set-logic QF_NRA)
(declare-const A Real) (declare-const us Real) (declare-const ms Real) (declare-const way Real)
(assert (>= A 0)) (assert (>= us 0)) (assert (>= ms 0))
(assert (>= (* 1000 ms) us))
(assert (>= (* way 2000000) (* A ms ms)))
; claim
(assert (not (>= (* way 2000000 1000000) (* A us us))))
(check-sat)
(reset)

; step: what is taken off, (V - s0)^2 / (2 A), rounds down: a / b towards 0
; mistake: s/(assert (<= 0 r))//
(set-logic QF_NIA)
(declare-const a Int) (declare-const b Int) (declare-const q Int) (declare-const r Int)
(assert (>= a 0)) (assert (> b 0))
(assert (= a (+ (* q b) r))) (assert (<= 0 r)) (assert (< r b))
; claim
(assert (not (<= (* q b) a)))
(check-sat)
(reset)

; step: the end of the capsule: a quotient rounded towards 0 is less than 1 off, on either axis, and
; step+ together less than 2
; mistake: s/(< (\* dx dx) 1)/(< (* dx dx) 4)/
(set-logic QF_NRA)
(declare-const dx Real) (declare-const dy Real)
(assert (< (* dx dx) 1)) (assert (< (* dy dy) 1))
; claim
(assert (not (< (+ (* dx dx) (* dy dy)) 4)))
(check-sat)
(reset)

; step: and in space
; mistake: s/(< (\* dz dz) 1)/(< (* dz dz) 4)/
(set-logic QF_NRA)
(declare-const dx Real) (declare-const dy Real) (declare-const dz Real)
(assert (< (* dx dx) 1)) (assert (< (* dy dy) 1)) (assert (< (* dz dz) 1))
; claim
(assert (not (< (+ (* dx dx) (* dy dy) (* dz dz)) 4)))
(check-sat)
(reset)

; step: a sample between steps of the grid, x_lo <= x <= x_hi <= x_lo + 1 on either axis: the corner
; step+ that is reckoned with is off by no more than the sum of the differences
; mistake: s/(<= (+ (\* dx dx) (\* dy dy)) (\* (+ sx sy)/(<= (+ (* dx dx) (* dy dy)) (* (- sx sy)/
(set-logic QF_NRA)
(declare-const dx Real) (declare-const dy Real) (declare-const sx Real) (declare-const sy Real)
(assert (<= 0 dx)) (assert (<= dx sx)) (assert (<= 0 dy)) (assert (<= dy sy))
; claim
(assert (not (<= (+ (* dx dx) (* dy dy)) (* (+ sx sy) (+ sx sy)))))
(check-sat)
(reset)
