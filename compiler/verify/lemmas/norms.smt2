; lemma: norms
; What the other lemmas use of the lengths of vectors, in any dimension: `c` is the inner product of
; vectors of the lengths `a` and `b`. Of coordinates only the first two steps know.
; code: compiler/codegen/kernel/motion.c | static int64_t dot(vec a, vec b) {

; step: in the plane, |u|^2 |v|^2 - c^2 is a square, hence never negative
; mistake: s/(\* ux vx) (\* uy vy)/(* ux vx) (* 2 uy vy)/
(set-logic QF_NRA)
(declare-const ux Real) (declare-const uy Real)
(declare-const vx Real) (declare-const vy Real)
(declare-const c Real) (declare-const k Real)
(assert (= c (+ (* ux vx) (* uy vy))))
(assert (= k (- (* ux vy) (* uy vx))))
; claim
(assert (not (= (- (* (+ (* ux ux) (* uy uy)) (+ (* vx vx) (* vy vy))) (* c c)) (* k k))))
(check-sat)
(reset)

; step: and in space the sum of three
; mistake: s/(\* uy vy) (\* uz vz)/(* uy vy) (* 2 uz vz)/
(set-logic QF_NRA)
(declare-const ux Real) (declare-const uy Real) (declare-const uz Real)
(declare-const vx Real) (declare-const vy Real) (declare-const vz Real)
(declare-const c Real) (declare-const kx Real) (declare-const ky Real) (declare-const kz Real)
(assert (= c (+ (* ux vx) (* uy vy) (* uz vz))))
(assert (= kx (- (* uy vz) (* uz vy))))
(assert (= ky (- (* uz vx) (* ux vz))))
(assert (= kz (- (* ux vy) (* uy vx))))
; claim
(assert (not (= (- (* (+ (* ux ux) (* uy uy) (* uz uz)) (+ (* vx vx) (* vy vy) (* vz vz))) (* c c))
                (+ (* kx kx) (* ky ky) (* kz kz)))))
(check-sat)
(reset)

; step: the triangle inequality, |u + v| <= |u| + |v|
; mistake: s/(\* 2 c) (\* b b)) (\* (+ a b) (+ a b))/(* 2 c) (* b b)) (* (- a b) (- a b))/
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real)
(assert (>= a 0)) (assert (>= b 0)) (assert (<= (* c c) (* a a b b)))
; claim
(assert (not (<= (+ (* a a) (* 2 c) (* b b)) (* (+ a b) (+ a b)))))
(check-sat)
(reset)

; step: what is between two places of a ball is in the ball
; mistake: s/(>= k 0)) (assert (<= k 1))/(>= k 0)) (assert (<= k 2))/
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real)
(declare-const k Real) (declare-const r Real)
(assert (>= a 0)) (assert (>= b 0)) (assert (<= (* c c) (* a a b b)))
(assert (>= k 0)) (assert (<= k 1))
(assert (<= a r)) (assert (<= b r))
; claim
(assert (not (<= (+ (* (- 1 k) (- 1 k) a a) (* 2 k (- 1 k) c) (* k k b b)) (* r r))))
(check-sat)
(reset)

; step: the projection onto a ball of radius r brings a place outside no farther from one inside
; mistake: s/(assert (<= b r))/(assert (<= b (* 2 r)))/
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real)
(declare-const k Real) (declare-const r Real)
(assert (> r 0)) (assert (>= b 0)) (assert (<= (* c c) (* a a b b)))
(assert (>= a r)) (assert (= (* k a) r))
(assert (<= b r))
; claim
(assert (not (<= (+ (* r r) (* (- 2) k c) (* b b)) (+ (* a a) (* (- 2) c) (* b b)))))
(check-sat)
(reset)

; step: nor from the projection of another place outside
; mistake: s/(assert (= (\* l b) r))/(assert (= (* l b) (* 2 r)))/
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real)
(declare-const k Real) (declare-const l Real) (declare-const r Real)
(assert (> r 0)) (assert (<= (* c c) (* a a b b)))
(assert (>= a r)) (assert (= (* k a) r))
(assert (>= b r)) (assert (= (* l b) r))
; claim
(assert (not (<= (+ (* k k a a) (* (- 2) k l c) (* l l b b)) (+ (* a a) (* (- 2) c) (* b b)))))
(check-sat)
(reset)
