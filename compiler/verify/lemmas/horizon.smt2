; lemma: horizon
; From the stamp of the newest sample until a recovery acts, no more passes than the age of the sample
; and the horizon of the check, D + jitter + latency; an older sample only makes it longer. Times in
; any unit, measured on one clock.
; code: compiler/analysis/reach.cpp | return body.position_age_us + lookahead_us + body.latency_us + body.jitter_us;
; code: compiler/codegen/kernel/motion.c | const int64_t t_us = s->age_us + horizon_us;
; code: compiler/analysis/derive.cpp | std::max(m.lookahead.duration_us - (k - 1) * d.period_us, d.period_us) + d.body.jitter_us;
; code: compiler/codegen/kernel/mode.c | return gap_us > longest_us && elapsed < 2 ? 2 : elapsed;

; step: a template: the check passes at `now` and next at `next`, which came no later than D + jitter
; step+ or is a missed tick (then the recovery took over with the timer of that tick); its command
; step+ acts within the latency
; mistake: s/(+ lookahead jitter latency)/(+ lookahead latency)/
; mistake: s/(assert (<= next (+ now lookahead jitter)))//
; mistake: s/(assert (<= acts (+ next latency)))/(assert (<= acts (+ next latency latency)))/
(set-logic QF_LRA)
(declare-const stamp Real) (declare-const now Real) (declare-const next Real)
(declare-const acts Real) (declare-const age Real)
(declare-const lookahead Real) (declare-const jitter Real) (declare-const latency Real)
(assert (>= lookahead 0)) (assert (>= jitter 0)) (assert (> latency 0))
(assert (<= stamp now)) (assert (= age (- now stamp)))
(assert (>= next now)) (assert (<= next (+ now lookahead jitter)))
(assert (<= acts (+ next latency)))
; claim
(assert (not (<= (- acts stamp) (+ age (+ lookahead jitter latency)))))
(check-sat)
(reset)

; step: an external recovery needs a period more: D >= 2 periods, the gap that counts as missed is
; step+ shorter by one
; mistake: s/(- lookahead period) jitter/lookahead jitter/
(set-logic QF_LRA)
(declare-const stamp Real) (declare-const now Real) (declare-const next Real)
(declare-const acts Real) (declare-const age Real) (declare-const period Real)
(declare-const lookahead Real) (declare-const jitter Real) (declare-const latency Real)
(assert (> period 0)) (assert (>= lookahead (* 2 period)))
(assert (>= jitter 0)) (assert (>= latency 0))
(assert (<= stamp now)) (assert (= age (- now stamp)))
(assert (>= next now)) (assert (<= next (+ now (- lookahead period) jitter)))
(assert (<= acts (+ next period latency)))
; claim
(assert (not (<= (- acts stamp) (+ age (+ lookahead jitter latency)))))
(check-sat)
(reset)

; step: what holds for the oldest sample that is used holds for a newer one: the horizon is monotone
; mistake: s/(assert (<= age most))/(assert (<= age (+ most 1)))/
(set-logic QF_LRA)
(declare-const age Real) (declare-const most Real) (declare-const ahead Real)
(assert (<= age most))
; claim
(assert (not (<= (+ age ahead) (+ most ahead))))
(check-sat)
(reset)
