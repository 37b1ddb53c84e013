; lemma: distances
; Lower bounds of distances in the kernel. To an edge of a zone by its direction u in parts of 2^-30,
; each component within 1/2 of the true one; to a segment by a root of its length that is rounded up;
; to anything in a box by the gaps of the boxes. How each is used, and that the foot of the
; perpendicular is decided exactly, is in the kernel's comments.
; code: compiler/codegen/kernel/geometry.c | const int64_t across = magnitude(v.y * e->ux_q30 - v.x * e->uy_q30) - (spread + 1) / 2;
; code: compiler/codegen/kernel/geometry.c | const int64_t gap = max_of(across, 0) / Q30;
; code: compiler/codegen/kernel/geometry.c | return (s->across << s->bits) / s->root;

; step: v x u less half of |vx| + |vy| is at most 2^30 times the distance, e and f being the errors of u
; mistake: s/(assert (<= (\* 2 f) 1))/(assert (<= f 1))/
; mistake: s/(\* 0.5 (+ ax ay))/(* 0.4 (+ ax ay))/
(set-logic QF_NRA)
(declare-const vx Real) (declare-const vy Real) (declare-const tx Real) (declare-const ty Real)
(declare-const e Real) (declare-const f Real) (declare-const ax Real) (declare-const ay Real)
(declare-const true_across Real) (declare-const across Real)
(assert (= ax (ite (<= 0 vx) vx (- vx)))) (assert (= ay (ite (<= 0 vy) vy (- vy))))
(assert (<= (* 2 e) 1)) (assert (<= (* (- 2) e) 1)) (assert (<= (* 2 f) 1)) (assert (<= (* (- 2) f) 1))
(assert (= true_across (- (* vy tx) (* vx ty))))
(assert (= across (- (* vy (+ tx e)) (* vx (+ ty f)))))
; claim
(assert (not (and (<= (- across (* 0.5 (+ ax ay))) true_across)
                  (<= (- (- across) (* 0.5 (+ ax ay))) (- true_across)))))
(check-sat)
(reset)

; step: and no more than 2 below it where |vx| + |vy| < 2^30, rounded: (spread + 1) / 2 and the quotient
; mistake: s/(assert (< spread 1073741824))/(assert (< spread 4294967296))/
(set-logic QF_NRA)
(declare-const spread Real) (declare-const length Real) (declare-const across Real)
(declare-const gap Real)
(assert (>= spread 0)) (assert (< spread 1073741824)) (assert (>= length 0))
(assert (>= across (- (* 1073741824 length) (* 0.5 spread) (* 0.5 (+ spread 1)))))
(assert (> (* 1073741824 (+ gap 1)) across))
; claim
(assert (not (> (+ gap 2.0000001) length)))
(check-sat)
(reset)

; step: to a segment: across / length, both scaled by 2^bits, with a root that is not too small
; mistake: s/(assert (>= (\* root root) (\* scale scale square)))//
(set-logic QF_NRA)
(declare-const across Real) (declare-const square Real) (declare-const scale Real)
(declare-const root Real) (declare-const quotient Real) (declare-const distance Real)
(assert (>= across 0)) (assert (> square 0)) (assert (>= scale 1)) (assert (> root 0))
(assert (>= distance 0)) (assert (>= quotient 0))
(assert (>= (* root root) (* scale scale square)))
(assert (<= (* quotient root) (* across scale)))
(assert (= (* distance distance square) (* across across)))
; claim
(assert (not (<= quotient distance)))
(check-sat)
(reset)

; step: boxes: of places in two, the gap along one axis is no more than the distance
; mistake: s/(assert (<= x right))//
(set-logic QF_NRA)
(declare-const x Real) (declare-const y Real) (declare-const a Real) (declare-const b Real)
(declare-const right Real) (declare-const left Real)
(assert (<= x right)) (assert (>= a left)) (assert (>= left right))
; claim
(assert (not (<= (* (- left right) (- left right)) (+ (* (- a x) (- a x)) (* (- b y) (- b y))))))
(check-sat)
(reset)

; step: the root of a minimum is the minimum of the roots, so that roots and quotients may wait
; mistake: s/(assert (<= p q))//
(set-logic QF_NRA)
(declare-const p Real) (declare-const q Real) (declare-const rp Real) (declare-const rq Real)
(assert (<= p q)) (assert (>= rp 0)) (assert (>= rq 0))
(assert (= (* rp rp) p)) (assert (= (* rq rq) q))
; claim
(assert (not (<= rp rq)))
(check-sat)
(reset)
