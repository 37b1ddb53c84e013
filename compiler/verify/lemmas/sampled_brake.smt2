; lemma: sampled_brake
; A brake that commands -b along a velocity that is off by at most eta, as long as the velocity that
; it goes by is faster than R = eta b / (b - d), against a push of at most d < b: the way stays within
; eta s / (b - d) + eta^2 / (b - d) + d s^2 / (2 b (b - d)) of the straight stop from the speed s, where
; nothing pushes within eta s / (2 b) + 2.2 eta^2 / b as well, and the speed never rises. Numbers are in units of b (accelerations) and eta (speeds); x = b / (b - d)
; = R, so that d = 1 - 1/x; v the true speed, m >= R the one that the brake goes by, c the cosine of
; the angle between them, q = 1 - c.
;
; How the steps make the lemma: as in stop_disturbed, all of the way is within what the point where an
; undisturbed brake would stop moves; that has the rate v (M + d) at most, M the first step's, while
; the speed falls by c - d at least. W(v) = (x - 1) v^2 / 2 + x g(v), g' = 1 + k(v), falls at least as
; fast (the steps with k), and W(s) - W(v) is at most what the lemma says, since the integral of k is 1
; at most: k = 1.265 - 0.93 v up to v = 1, then 1.085 - 0.75 v down to 0 where x <= 50/49, and 0.66 up
; to v = 1, then 1 / (3 v^2), elsewhere. Everything is worst where q is the largest that the angle
; allows. In the steps, z = x q.
;
; Undisturbed a turn of the sine eta / v moves that point across by half of eta: g' = 1/2 + k, with
; k = 1.75 - 0.92 v up to the root of 2, and 0.85 / v^2 from there on, the integral of which is 2.2 at
; most.
; code: runtime/core/pilot_point.cpp | if (!latched_) return against(v);
; code: runtime/core/pilot_point.cpp | return commanded((-limits_.brake_mps2 / std::max(norm(v), limits_.brake_mps2 * reaction_s_)) * v);
; code: runtime/core/pilot_point.cpp | rest_mps_ = eta_mps * limits_.brake_mps2 / (limits_.brake_mps2 - limits_.disturbance_mps2);
; code: compiler/analysis/limits.cpp | b.brake_lag_ms = half ? div_up(1000 * eta, 2 * left_mmps2) : b.brake_late_ms;
; code: compiler/analysis/limits.cpp | b.hold_mm = (half ? div_up(calm_eta_shares * eta * eta, calm_eta_parts * left_mmps2)
; code: compiler/codegen/kernel/motion.c | return b->radius_mm + div_up(s1 * b->brake_lag_ms, 1000) +

; step: M, of the turn alone: -u of unit length instead of -v/|v| moves that point with v (1 - c)
; step+ along v and v sin / 2 across; M^2 = (1 - c)^2 + (1 - c^2) / 4
; mistake: s/(+ (\* 0.75 q q) (\* 0.5 q))/(+ (* 0.75 q q) (* 0.25 q))/
(set-logic QF_NRA)
(declare-const c Real) (declare-const s Real) (declare-const q Real)
(declare-const along Real) (declare-const across Real)
(assert (<= (- 1) c)) (assert (<= c 1)) (assert (= (+ (* s s) (* c c)) 1)) (assert (= q (- 1 c)))
(assert (= (* 2 along) (+ 2 (- c) (- c)))) (assert (= (* 2 across) s))
; claim
(assert (not (= (+ (* along along) (* across across)) (+ (* 0.75 q q) (* 0.5 q)))))
(check-sat)
(reset)

; step: the angle: |m - v| <= 1 leaves 2 v m c >= v^2 + m^2 - 1, and that with m >= x >= 1
; step+ one of two bounds: where v^2 <= x^2 + 1 that of m = x, and elsewhere c^2 >= 1 - 1/v^2
; mistake: s/(assert (>= m x))//
(set-logic QF_NRA)
(declare-const v Real) (declare-const m Real) (declare-const c Real) (declare-const x Real)
(assert (> v 0)) (assert (>= x 1)) (assert (>= m x)) (assert (<= c 1))
(assert (>= (* 2 v m c) (+ (* v v) (* m m) (- 1))))
; claim
(assert (not (ite (<= (* v v) (+ (* x x) 1)) (>= (* 2 v x c) (+ (* v v) (* x x) (- 1)))
                  (and (>= c 0) (>= (* v v c c) (- (* v v) 1))))))
(check-sat)
(reset)

; step: the speed falls: c > d where something pushes
; mistake: s/(assert (>= m x))/(assert (>= m 1))/
(set-logic QF_NRA)
(declare-const v Real) (declare-const m Real) (declare-const c Real) (declare-const x Real)
(declare-const d Real)
(assert (> v 0)) (assert (> x 1)) (assert (>= m x)) (assert (= (* x (- 1 d)) 1))
(assert (>= (* 2 v m c) (+ (* v v) (* m m) (- 1))))
; claim
(assert (not (> c d)))
(check-sat)
(reset)

; step: what W has to fall by: the push, with its part along v, makes it (1 + k)(1 - x q) >=
; step+ v (M + (x - 1) q)
; mistake: s/(\* x (+ 1 k))/(+ 1 k)/
(set-logic QF_NRA)
(declare-const v Real) (declare-const x Real) (declare-const d Real) (declare-const q Real)
(declare-const M Real) (declare-const k Real)
(assert (>= v 0)) (assert (>= x 1)) (assert (= (* x (- 1 d)) 1)) (assert (>= M 0))
(assert (>= q 0)) (assert (< q (- 1 d))) (assert (>= k 0))
(assert (>= (* (+ 1 k) (- 1 (* x q))) (* v (+ M (* (- x 1) q)))))
(declare-const slope Real)
(assert (= slope (+ (* v (- x 1)) (* x (+ 1 k)))))
; claim
(assert (not (<= (* v (+ M d)) (* slope (- (- 1 q) d)))))
(check-sat)
(reset)

; step: larger q, larger M: the largest q is the worst one
; mistake: s/(assert (<= q q2))/(assert (<= q (* 2 q2)))/
(set-logic QF_NRA)
(declare-const q Real)
(declare-const q2 Real)
(declare-const M Real)
(declare-const M2 Real)
(assert (>= q 0)) (assert (<= q q2)) (assert (>= M 0)) (assert (>= M2 0))
(assert (= (* M M) (+ (* 0.75 q q) (* 0.5 q))))
(assert (= (* M2 M2) (+ (* 0.75 q2 q2) (* 0.5 q2))))
; claim
(assert (not (<= M M2)))
(check-sat)
(reset)

; step: and what is asked of k
; mistake: s/(assert (<= M M2))/(assert (<= M (* 2 M2)))/
(set-logic QF_NRA)
(declare-const v Real)
(declare-const x Real)
(declare-const q Real)
(declare-const q2 Real)
(declare-const M Real)
(declare-const M2 Real)
(declare-const k Real)
(assert (> v 0)) (assert (>= x 1)) (assert (>= k 0)) (assert (<= q q2)) (assert (<= M M2))
(assert (>= (* (+ 1 k) (- 1 (* x q2))) (* v (+ M2 (* (- x 1) q2)))))
; claim
(assert (not (>= (* (+ 1 k) (- 1 (* x q))) (* v (+ M (* (- x 1) q))))))
(check-sat)
(reset)

; step: M is below its tangents
; mistake: s/(+ 0.2105 (\* 0.9101 q))/(+ 0.2 (* 0.9101 q))/
; mistake: s/(+ 0.1768 (\* 0.9725 q))/(+ 0.17 (* 0.9725 q))/
; mistake: s/(+ (\/ 1 6) q)/(+ (\/ 1 7) q)/
(set-logic QF_NRA)
(declare-const q Real)
(declare-const M Real)
(assert (>= q 0)) (assert (>= M 0)) (assert (= (* M M) (+ (* 0.75 q q) (* 0.5 q))))
; claim
(assert (not (and (<= M (+ 0.2105 (* 0.9101 q))) (<= M (+ 0.1768 (* 0.9725 q)))
                  (<= M (+ (/ 1 6) q)))))
(check-sat)
(reset)

; step: little push, v <= 1
; mistake: s/(= k (- 1.265/(= k (- 1.2/
(set-logic QF_NRA)
(declare-const v Real)
(declare-const x Real)
(declare-const q Real)
(declare-const z Real)
(declare-const M Real)
(declare-const k Real)
(assert (> v 0)) (assert (>= z 0)) (assert (<= (* 2 v z) (- 1 (* (- x v) (- x v)))))
(assert (>= x 1)) (assert (<= (* 49 z) (* 50 q))) (assert (<= v 1))
(assert (<= M (+ 0.2105 (* 0.9101 q))))
(assert (= k (- 1.265 (* 0.93 v))))
; claim
(assert (not (>= (* (+ 1 k) (- 1 z)) (* v (+ M (- z q))))))
(check-sat)
(reset)

; step: little push, v >= 1, while v^2 <= x^2 + 1: up to 1.43
; mistake: s/(= k (- 1.085/(= k (- 1.05/
(set-logic QF_NRA)
(declare-const v Real)
(declare-const x Real)
(declare-const q Real)
(declare-const z Real)
(declare-const M Real)
(declare-const k Real)
(assert (> v 0)) (assert (>= z 0)) (assert (<= (* 2 v z) (- 1 (* (- x v) (- x v)))))
(assert (<= (* 49 x) 50)) (assert (<= (* 49 z) (* 50 q))) (assert (>= v 1)) (assert (<= v 1.43))
(assert (<= M (+ 0.1768 (* 0.9725 q))))
(assert (= k (- 1.085 (* 0.75 v))))
; claim
(assert (not (>= (* (+ 1 k) (- 1 z)) (* v (+ M (- z q))))))
(check-sat)
(reset)

; step: little push, beyond: no k is needed; by s = 1/v, the sine of the angle
; mistake: s/(assert (<= q 0.3))/(assert (<= q 0.5))/
; mistake: s/(assert (<= (\* 49 x) 50))/(assert (<= x 2))/
(set-logic QF_NRA)
(declare-const q Real)
(declare-const M Real)
(declare-const s Real)
(declare-const x Real)
(assert (>= x 1)) (assert (<= (* 49 x) 50))
(assert (>= q 0)) (assert (<= q 0.3)) (assert (>= s 0)) (assert (= (* s s) (- (* 2 q) (* q q))))
(assert (>= M 0)) (assert (= (* M M) (+ (* q q) (* 0.25 s s))))
; claim
(assert (not (>= (* s (- 1 (* x q))) (+ M (* (- x 1) q)))))
(check-sat)
(reset)

; step: more, v <= 1
; mistake: s/(= k 0.66)/(= k 0.6)/
(set-logic QF_NRA)
(declare-const v Real)
(declare-const x Real)
(declare-const q Real)
(declare-const z Real)
(declare-const M Real)
(declare-const k Real)
(assert (> v 0)) (assert (>= z 0)) (assert (<= (* 2 v z) (- 1 (* (- x v) (- x v)))))
(assert (>= (* 49 x) 50)) (assert (<= v 1))
(assert (<= M (+ (/ 1 6) q)))
(assert (= k 0.66))
; claim
(assert (not (>= (* (+ 1 k) (- 1 z)) (* v (+ M (- z q))))))
(check-sat)
(reset)

; step: more, v >= 1, while v^2 <= x^2 + 1
; mistake: s/(= (\* 3 v v k) 1)/(= (* 6 v v k) 1)/
(set-logic QF_NRA)
(declare-const v Real)
(declare-const x Real)
(declare-const q Real)
(declare-const k Real)
(assert (>= v 1)) (assert (>= (* 49 x) 50)) (assert (<= (* v v) (+ (* x x) 1)))
(assert (= (* 2 v x q) (- 1 (* (- x v) (- x v))))) (assert (>= q 0)) (assert (<= q 1))
(assert (= (* 3 v v k) 1))
(define-fun left () Real (- (* (+ 1 k) (- 1 (* x q))) (* v (- x 1) q)))
; claim
(assert (not (and (>= left 0) (>= (* left left) (* v v (+ (* 0.75 q q) (* 0.5 q)))))))
(check-sat)
(reset)

; step: by t, the tangent of half of the angle: q = s t, c / s = (1 - t^2) / (2 t), M^2 = s^2 (t^2 + 1/4)
; mistake: s/(= (\* c w) (- 1 (\* t t)))/(= (* c w) (- 1 t))/
(set-logic QF_NRA)
(declare-const t Real)
(declare-const c Real)
(declare-const s Real)
(declare-const w Real)
(assert (> t 0)) (assert (= w (+ 1 (* t t))))
(assert (= (* c w) (- 1 (* t t)))) (assert (= (* s w) (* 2 t)))
; claim
(assert (not (and (= (- 1 c) (* s t)) (= (* 2 t c) (* s (- 1 (* t t))))
                  (= (+ (* (- 1 c) (- 1 c)) (* 0.25 s s)) (* s s (+ (* t t) 0.25)))
                  (= (+ (* s s) (* c c)) 1))))
(check-sat)
(reset)

; step: more, beyond: x is at most c / s there, and k = s^2 / 3. Divided by s, times w^3
; mistake: s/(+ (\* t t) 0.25)/(+ (* t t) 0.45)/
(set-logic QF_NRA)
(declare-const t Real)
(declare-const m Real)
(declare-const w Real)
(assert (>= t 0)) (assert (<= t 0.415)) (assert (= w (+ 1 (* t t))))
(assert (>= m 0)) (assert (= (* m m) (+ (* t t) 0.25)))
; claim
(assert (not (>= (* (+ (* w w) (/ (* 4 t t) 3)) (- w (* t (- 1 (* t t)))))
                 (* w w w (+ m (- (* 0.5 (- 1 (* t t))) t))))))
(check-sat)
(reset)

; step: a smaller x asks for less of k
; mistake: s/(assert (<= x y))//
(set-logic QF_NRA)
(declare-const s Real)
(declare-const M Real)
(declare-const q Real)
(declare-const x Real)
(declare-const y Real)
(declare-const k Real)
(assert (>= s 0)) (assert (>= q 0)) (assert (<= x y)) (assert (>= k 0))
(assert (>= (* s (+ 1 k) (- 1 (* y q))) (+ M (* (- y 1) q))))
; claim
(assert (not (>= (* s (+ 1 k) (- 1 (* x q))) (+ M (* (- x 1) q)))))
(check-sat)
(reset)

; step: the integral of k: little push, up to 1 and then up to where it is 0, at 1 + 0.335 / 0.75; more,
; step+ up to 1 and then for ever, that of 1 / (3 v^2) from 1
; mistake: s/0.465/0.265/
; mistake: s/(+ 0.66 (\/ 1 3))/(+ 0.86 (\/ 1 3))/
(set-logic QF_NRA)
(declare-const little Real)
(declare-const more Real)
(declare-const end Real)
(assert (= (* 0.75 end) 1.085))
(assert (= little (+ (- 1.265 0.465) (- (* 1.085 (- end 1)) (* 0.375 (- (* end end) 1))))))
(assert (= more (+ 0.66 (/ 1 3))))
; claim
(assert (not (and (<= little 1) (<= more 1))))
(check-sat)
(reset)

; step: undisturbed, x = 1: what g has to fall by, from the largest angle on
; mistake: s/(assert (<= M M2))/(assert (<= M (* 2 M2)))/
(set-logic QF_NRA)
(declare-const v Real) (declare-const slope Real)
(declare-const q Real) (declare-const q2 Real) (declare-const M Real) (declare-const M2 Real)
(assert (> v 0)) (assert (>= slope 0)) (assert (<= q q2)) (assert (<= M M2))
(assert (>= (* slope (- 1 q2)) (* v M2)))
; claim
(assert (not (>= (* slope (- 1 q)) (* v M))))
(check-sat)
(reset)

; step: undisturbed, v^2 <= 2: the largest q is 1 - v / 2, and g' = 1/2 + k, k = 1.75 - 0.92 v
; mistake: s/(- 1.75/(- 1.7/
(set-logic QF_NRA)
(declare-const v Real)
(declare-const q Real)
(declare-const M Real)
(declare-const k Real)
(assert (> v 0)) (assert (<= (* v v) 2)) (assert (= q (- 1 (* 0.5 v))))
(assert (>= M 0)) (assert (= (* M M) (+ (* 0.75 q q) (* 0.5 q))))
(assert (= k (- 1.75 (* 0.92 v))))
; claim
(assert (not (>= (* (+ 0.5 k) (- 1 q)) (* v M))))
(check-sat)
(reset)

; step: undisturbed, beyond: the sine of the angle is 1 / v, k = 0.85 / v^2
; mistake: s/0.85/0.65/
(set-logic QF_NRA)
(declare-const s Real)
(declare-const c Real)
(declare-const M Real)
(assert (> s 0)) (assert (<= (* 2 s s) 1)) (assert (>= c 0)) (assert (= (+ (* s s) (* c c)) 1))
(assert (>= M 0)) (assert (= (* M M) (+ (* (- 1 c) (- 1 c)) (* 0.25 s s))))
; claim
(assert (not (>= (* s (+ 0.5 (* 0.85 s s)) c) M)))
(check-sat)
(reset)

; step: the integral of k, undisturbed: up to the root of 2 and from there for ever
; mistake: s/(\* 1.75 root)/(* 1.85 root)/
(set-logic QF_NRA)
(declare-const root Real)
(assert (> root 0)) (assert (= (* root root) 2))
; claim
(assert (not (<= (+ (* 1.75 root) (- 0.92) (/ 0.85 root)) 2.2)))
(check-sat)
(reset)
