#!/usr/bin/env bash
# compiler/docs/lemmas.md has a section of the name of each lemma, and no other; and the test of a
# lemma can fail: a lemma that is wrong, one that says nothing, one without a mistake, a quotation
# that is out of date, and a machine without z3 are noticed.
# Usage: pages_test.sh ROOT
set -euo pipefail

root=${1:?the root of the repository is needed}
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

lemmas=$(cd -- "$root/compiler/verify/lemmas" && printf '%s\n' *.smt2 | sed 's/\.smt2$//' | LC_ALL=C sort)
sections=$(sed -n 's/^### \([a-z_]*\)$/\1/p' "$root/compiler/docs/lemmas.md" | LC_ALL=C sort)
if ! diff <(printf '%s\n' "$lemmas") <(printf '%s\n' "$sections"); then
  printf 'compiler/docs/lemmas.md and compiler/verify/lemmas do not hold the same lemmas\n'
  failures=$((failures + 1))
fi

cat >"$scratch/base.smt2" <<'TEXT'
; lemma: base
; code: quoted.c | return a + b;
; step: sums of what is above zero are
; mistake: s/(assert (> y 0))//
(set-logic QF_LRA)
(declare-const x Real) (declare-const y Real)
(assert (> x 0)) (assert (> y 0))
; claim
(assert (not (> (+ x y) 0)))
(check-sat)
(reset)
TEXT
printf 'int sum(int a, int b) {\n  return a\n      + b;\n}\n' >"$scratch/quoted.c"

expect() { # WHAT EXIT_CODE TEXT SED_EXPRESSION [PATH]
  local status=0
  mkdir -p "$scratch/case"
  sed "$4" "$scratch/base.smt2" >"$scratch/case/base.smt2"
  PATH=${5:-$PATH} bash "$here/lemma_test.sh" "$scratch/case/base.smt2" "$scratch" \
    >"$scratch/log" 2>&1 || status=$?
  if ((status != $2)) || { [[ -n $3 ]] && ! grep -qF -- "$3" "$scratch/log"; }; then
    printf '%s: exit code %d, not %d, or no text "%s":\n' "$1" "$status" "$2" "$3"
    cat -- "$scratch/log"
    failures=$((failures + 1))
  fi
}

expect 'a sound lemma' 0 '' ''
expect 'a wrong claim' 1 'not proved (sat)' 's/(> (+ x y) 0)/(> (+ x y) 1)/'
expect 'hypotheses that exclude each other' 1 'hypotheses not met (unsat)' 's/(> y 0)/(> y 0)) (assert (< y 0)/'
expect 'a mistake that matters to nobody' 1 'nobody notices' 's/s.(assert (> y 0))../s_(> x 0)_(> x 1)_/'
expect 'a mistake that changes nothing' 1 'changes nothing' 's/^; mistake.*/; mistake: s_nothing_something_/'
expect 'no mistake' 1 'no mistake breaks' '/^; mistake/d'
expect 'text that z3 does not read' 1 'not proved' 's/(> x 0)/(> x)/'
expect 'a missing check' 1 'each step has one' '/^(check-sat)/d'
expect 'code that has changed' 1 'does not read like this' 's/a + b;/a - b;/'
expect 'code that has gone' 1 'is not there' 's/quoted.c/gone.c/'
mkdir "$scratch/few"
for tool in bash sed grep basename tr cat; do
  ln -s "$(command -v $tool)" "$scratch/few/$tool"
done
expect 'no z3' 1 'apt-get install z3' '' "$scratch/few"

((failures == 0))
