; lemma: space_gap
; Robots in space: two segments are no closer to each other than their shadows on a line of any
; direction n. `an` and `bn` are the inner products of n and the ends of the one, `cn` and `dn` those
; of n and the ends of the other one. So n need not be right, and may be cut off to fewer digits.
; code: compiler/codegen/kernel/spots.c | const int64_t gap = max_of(min_of(an, bn) - max_of(cn, dn), min_of(cn, dn) - max_of(an, bn));
; code: compiler/codegen/kernel/spots.c | return gap <= 0 ? 0 : gap / root_up(spot_dot(n, n));

; step: places of segments have their shadows between those of the ends
; mistake: s/(assert (<= k 1))//
; mistake: s/(- lowest highest)/(- (ite (<= an bn) bn an) highest)/
(set-logic QF_NRA)
(declare-const an Real) (declare-const bn Real) (declare-const cn Real) (declare-const dn Real)
(declare-const k Real) (declare-const l Real) (declare-const pn Real) (declare-const qn Real)
(declare-const lowest Real) (declare-const highest Real)
(assert (<= 0 k)) (assert (<= k 1)) (assert (<= 0 l)) (assert (<= l 1))
(assert (= pn (+ an (* k (- bn an))))) (assert (= qn (+ cn (* l (- dn cn)))))
(assert (= lowest (ite (<= an bn) an bn))) (assert (= highest (ite (<= cn dn) dn cn)))
; claim
(assert (not (>= (- pn qn) (- lowest highest))))
(check-sat)
(reset)

; step: the distance is no less than how far the shadows are apart over the length of n, which is
; step+ rounded up; the inner product is no more than the product of the lengths (norms)
; mistake: s/(assert (>= root size))/(assert (<= root size))/
; mistake: s/(assert (<= (\* least root) gap))/(assert (<= (* least root) (* 2 gap)))/
(set-logic QF_NRA)
(declare-const gap Real) (declare-const apart Real) (declare-const size Real)
(declare-const root Real) (declare-const least Real)
(assert (> size 0)) (assert (>= apart 0)) (assert (>= root size))
(assert (> gap 0)) (assert (<= gap (* apart size)))
(assert (>= least 0)) (assert (<= (* least root) gap))
; claim
(assert (not (<= least apart)))
(check-sat)
(reset)

; step: the numbers fit: coordinates within 2^29, a direction below 2^29
; mistake: s/(<= nz 536870911)/(<= nz 17179869184)/
(set-logic QF_NIA)
(declare-const x Int) (declare-const y Int) (declare-const z Int)
(declare-const nx Int) (declare-const ny Int) (declare-const nz Int)
(assert (<= 0 x)) (assert (<= x 536870912)) (assert (<= 0 y)) (assert (<= y 536870912))
(assert (<= 0 z)) (assert (<= z 536870912))
(assert (<= 0 nx)) (assert (<= nx 536870911)) (assert (<= 0 ny)) (assert (<= ny 536870911))
(assert (<= 0 nz)) (assert (<= nz 536870911))
; claim
(assert (not (<= (+ (* x nx) (* y ny) (* z nz)) 4611686018427387904)))
(check-sat)
(reset)
