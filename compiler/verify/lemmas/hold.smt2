; lemma: hold
; A hold of the frequency w, critically damped, x'' = -w^2 (x + ep) - 2 w (x' + ev) + d, from rest at
; its place: it never is farther off than e_p + 2 e_v / w + d / w^2, however its errors and what pushes
; it change within their bounds. As two lags in a row: y = x' + w x, y' = -w y + u with u of at most
; U = w^2 e_p + 2 w e_v + d; of vectors these are lengths, and rates of lengths are at most the lengths
; of rates. Without a delay: what delay and sampling add is not part of this lemma (see the page).
; code: runtime/core/pilot_point.cpp | const Vec3 spring = (omega_radps_ * omega_radps_) * (hold_at_ - p);
; code: runtime/core/pilot_point.cpp | const Vec3 damper = (-2 * omega_radps_) * v;
; code: runtime/core/pilot_point.cpp | omega_radps_ = std::min(omega_radps_, std::sqrt(share_mps2 / limits_.position_error_m));
; code: compiler/analysis/limits.cpp | 2 * b.velocity_error_mmps / omega + b.disturbance_mmps2 / (omega * omega);

; step: the two lags are the hold: x'' = y' - w x'
; mistake: s/(\* (- 2) w v)/(* (- 1) w v)/
(set-logic QF_NRA)
(declare-const w Real) (declare-const x Real) (declare-const v Real) (declare-const u Real)
(declare-const y Real) (declare-const acc Real)
(assert (> w 0)) (assert (= y (+ v (* w x))))
(assert (= acc (+ (* (- 1) w w x) (* (- 2) w v) u)))
; claim
(assert (not (= (- (+ (* (- 1) w y) u) (* w v)) acc)))
(check-sat)
(reset)

; step: what acts from without is at most U
; mistake: s/(\* 2 w ev))/(* w ev))/
(set-logic QF_NRA)
(declare-const w Real) (declare-const ep Real) (declare-const ev Real) (declare-const d Real)
(declare-const p Real) (declare-const v Real) (declare-const push Real) (declare-const u Real)
(assert (> w 0)) (assert (<= 0 p)) (assert (<= p ep)) (assert (<= 0 v)) (assert (<= v ev))
(assert (<= 0 push)) (assert (<= push d))
(assert (<= u (+ (* w w p) (* 2 w v) push)))
(define-fun most () Real (+ (* w w ep) (+ d (* 2 w ev))))
; claim
(assert (not (<= u most)))
(check-sat)
(reset)

; step: y never leaves the ball of U / w: on its rim the length does not grow
; mistake: s/(assert (<= u U))/(assert (<= u (* 2 U)))/
(set-logic QF_NRA)
(declare-const w Real) (declare-const U Real) (declare-const u Real) (declare-const y Real)
(declare-const rate Real)
(assert (> w 0)) (assert (>= U 0)) (assert (<= 0 u)) (assert (<= u U))
(assert (= (* w y) U))
(assert (<= rate (+ (* (- 1) w y) u)))
; claim
(assert (not (<= rate 0)))
(check-sat)
(reset)

; step: nor x that of U / w^2
; mistake: s/(assert (= (\* w w x) U))/(assert (= (* 2 w w x) U))/
(set-logic QF_NRA)
(declare-const w Real) (declare-const U Real) (declare-const x Real) (declare-const y Real)
(declare-const rate Real)
(assert (> w 0)) (assert (>= U 0)) (assert (<= 0 y)) (assert (<= (* w y) U))
(assert (= (* w w x) U))
(assert (<= rate (+ (* (- 1) w x) y)))
; claim
(assert (not (<= rate 0)))
(check-sat)
(reset)

; step: that is e_p + 2 e_v / w + d / w^2
; mistake: s/(\* 2 w ev) d))/(* w ev) d))/
(set-logic QF_NRA)
(declare-const w Real) (declare-const ep Real) (declare-const ev Real) (declare-const d Real)
(declare-const x Real) (declare-const by_speed Real) (declare-const by_push Real)
(assert (> w 0)) (assert (>= ep 0)) (assert (>= ev 0)) (assert (>= d 0))
(assert (= (* w w x) (+ (* w w ep) (* 2 w ev) d)))
(assert (= (* w by_speed) (* 2 ev))) (assert (= (* w w by_push) d))
; claim
(assert (not (= x (+ ep by_speed by_push))))
(check-sat)
(reset)

; step: what its errors ask for of the brake is at most three quarters of what the push leaves: w is at
; step+ most (b - d) / (4 e_v), and its square at most (b - d) / (4 e_p)
; mistake: s/(assert (<= (\* 4 w w ep) left))//
; mistake: s/(assert (<= (\* 4 w ev) left))/(assert (<= (* 2 w ev) left))/
(set-logic QF_NRA)
(declare-const w Real) (declare-const ep Real) (declare-const ev Real) (declare-const left Real)
(declare-const asked Real)
(assert (> w 0)) (assert (>= ep 0)) (assert (>= ev 0)) (assert (> left 0))
(assert (<= (* 4 w w ep) left)) (assert (<= (* 4 w ev) left))
(assert (<= asked (+ (* w w ep) (* 2 w ev))))
; claim
(assert (not (<= asked (* 0.75 left))))
(check-sat)
(reset)
