#!/usr/bin/env bash
# What no case study has: a plan inside one zone, whose table the contract has to name as the kernel
# does; a plan inside of several, which is taken for granted; kernels with decisions that have the
# same number of monitors, and others.
# Usage: forms_test.sh RTAC GOLDEN_CASES
set -euo pipefail

rtac=$1 cases=$2
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

breach() {
  printf '%s\n' "$*"
  failures=$((failures + 1))
}
proof_of() { # SPEC NAME
  "$rtac" build --contracts "$1" -o "$scratch/$2" 2>/dev/null
  cat -- "$scratch/$2"/*_proof.c >"$scratch/$2.c"
}

proof_of "$cases/two_kinds/spec.rta" same_number
proof=$scratch/same_number.c
zone=$(sed -n 's/.*ensures plan_ok: out->mode == 0 ==> plan_keeps(&\([a-z0-9_]*\), plan, 1);$/\1/p' "$proof")
grep -q "^static const zone $zone = " "$proof" || breach "there is no table \`$zone\` of the plan's zone"
grep -qF "ensures \\result.lo >= 0 ==> plan_keeps(&$zone, v, 1);" "$proof" ||
  breach 'what the monitor finds of a plan says nothing'
! grep -E '^/\* held: [a-z_]*: (plans|several)' "$proof" || breach 'these are proved'
grep -qF 'requires count == 1;' "$proof" || breach 'mode_step does not know the number of monitors'

proof_of "$cases/plan_only/spec.rta" plans
grep -q '^/\* held: route_check_plan_ok_now: plans ' "$scratch/plans.c" ||
  breach 'a plan in several zones is not taken for granted'
! grep -F 'plan_keeps(&' "$scratch/plans.c" || breach 'a plan in several zones is claimed to be in one'

mkdir -p "$scratch/golden/cases"
cp -r -- "$cases/parts" "$scratch/golden/parts"
sed 's/^  priority fence;/  priority fence > edge;/
     s/^decision fly for/monitor edge for c : Cart {\n  "SR-3: and a little inside of it"\n  always  clearance(c, room) >= 1 cm;\n  ahead   100 ms;\n  recover inwards;\n}\n&/' \
  "$cases/two_kinds/spec.rta" >"$scratch/golden/cases/spec.rta"
proof_of "$scratch/golden/cases/spec.rta" other_numbers
grep -q '^/\* held: mode_step: several ' "$scratch/other_numbers.c" ||
  breach 'the switching of decisions with different numbers of monitors is not taken for granted'
! grep -F 'requires count ==' "$scratch/other_numbers.c" ||
  breach 'mode_step is said to be called with one number of monitors'

((failures == 0))
