; lemma: roots
; The integer square roots of the kernel. One step of Newton from any start is never below the root,
; and brings a relative error e to e^2 / (2 (1 + e)); from a start that is within 0.6 % (tested over
; all leading digits: tests/kernel/arithmetic_test.cpp) one step is less than 1 above roots up to 2^15,
; two above those up to 2^31; the last comparison makes it exact.
; code: compiler/codegen/kernel/arith.c | root = (root + a / root) / 2; return root * root > a ? root - 1 : root;
; code: compiler/codegen/kernel/arith.c | root = (root + square / root) / 2; root = (root + square / root) / 2;
; code: compiler/codegen/kernel/arith.c | return root * root == a ? root : root + 1;

; step: a step of Newton in integers, n = (r + a / r) / 2, both quotients rounded down: (n + 1)^2 > a
; mistake: s/(assert (= (+ r q) (+ (\* 2 n) odd)))/(assert (= (+ r q) (+ (* 4 n) odd)))/
(set-logic QF_NRA)
(declare-const a Real) (declare-const r Real) (declare-const q Real) (declare-const n Real)
(declare-const odd Real)
(assert (>= a 0)) (assert (>= r 1)) (assert (>= q 0)) (assert (>= n 0))
(assert (<= (* q r) a)) (assert (>= (* (+ q 1) r) (+ a 1)))
(assert (= (+ r q) (+ (* 2 n) odd))) (assert (<= 0 odd)) (assert (<= odd 1))
; claim
(assert (not (>= (* (+ n 1) (+ n 1)) a)))
(check-sat)
(reset)

; step: the relative error
; mistake: s/(\* e e) (\* 2 (+ 1 e) f)/(* e e) (* 3 (+ 1 e) f)/
(set-logic QF_NRA)
(declare-const s Real) (declare-const r Real) (declare-const n Real)
(declare-const e Real) (declare-const f Real)
(assert (> s 0)) (assert (> r 0)) (assert (> e (- 1)))
(assert (= r (* s (+ 1 e)))) (assert (= (* 2 n r) (+ (* r r) (* s s)))) (assert (= n (* s (+ 1 f))))
; claim
(assert (not (= (* e e) (* 2 (+ 1 e) f))))
(check-sat)
(reset)

; step: from 0.6 % and 1 (the start is a whole number) one step is less than 1 above roots s of 2^7 to
; step+ 2^15, two are above those of up to 2^31, e being the error of the start relative to the root
; mistake: s/(<= s 32768)/(<= s 131072)/
; mistake: s/(<= big 2147483648)/(<= big 21474836480000)/
(set-logic QF_NRA)
(declare-const s Real) (declare-const e Real) (declare-const f Real) (declare-const g Real)
(declare-const big Real) (declare-const e2 Real) (declare-const h Real)
(assert (<= (- 0.006) e)) (assert (<= e 0.00605)) (assert (<= s 32768)) (assert (> s 0))
(assert (= (* e e) (* 2 (+ 1 e) f)))
(assert (<= (- 0.006) e2)) (assert (<= e2 0.00601)) (assert (<= big 2147483648)) (assert (> big 0))
(assert (= (* e2 e2) (* 2 (+ 1 e2) g))) (assert (= (* g g) (* 2 (+ 1 g) h)))
; claim
(assert (not (and (< (* s f) 1) (< (* big h) 1))))
(check-sat)
(reset)

; step: from a number n that is the root, rounded down, or 1 more, the comparison makes it exact
; mistake: s/(assert (<= (\* (- n 1) (- n 1)) a))//
(set-logic QF_NRA)
(declare-const a Real) (declare-const n Real) (declare-const root Real)
(assert (>= a 0)) (assert (>= n 1))
(assert (> (* (+ n 1) (+ n 1)) a)) (assert (<= (* (- n 1) (- n 1)) a))
(assert (= root (ite (> (* n n) a) (- n 1) n)))
; claim
(assert (not (and (<= (* root root) a) (> (* (+ root 1) (+ root 1)) a))))
(check-sat)
(reset)

; step: rounded up, from a whole number, 0 or at least 1
; mistake: s/(ite (= (\* down down) a) down (+ down 1))/down/
(set-logic QF_NRA)
(declare-const a Real) (declare-const down Real) (declare-const up Real)
(assert (>= a 0)) (assert (or (= down 0) (>= down 1)))
(assert (<= (* down down) a)) (assert (> (* (+ down 1) (+ down 1)) a))
(assert (= up (ite (= (* down down) a) down (+ down 1))))
; claim
(assert (not (and (>= (* up up) a) (or (= up 0) (< (* (- up 1) (- up 1)) a)))))
(check-sat)
(reset)
