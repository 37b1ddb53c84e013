#!/usr/bin/env bash
# The kernel with contracts is the kernel: C99 that compiles without a warning, and the same text
# but for comments and for tables, which it only declares. The contracts come from the
# specification: a kernel with a planted bug has the same ones, and another number in the
# specification has others.
# Usage: contract_test.sh RTAC CC SPEC
set -euo pipefail

rtac=$1 cc=$2 spec=$3
name=$(basename -- "$spec" .rta)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

breach() {
  printf '%s: %s\n' "$name" "$*"
  failures=$((failures + 1))
}

# Lines of contracts, and of what stands in front.
contracts() { # FILE
  grep -E '^ *(/\*@|@|@\*/)|^/\* (held|gap): ' "$1" || true
}
# Without contracts and tables.
code() { # FILE
  grep -vE '^ *(/\*@|@|@\*/)|^/\* (held|gap): |^extern const ' "$1" |
    awk '/^static const [a-z0-9_]+ [a-z0-9_]+\[\] = \{$/ && !/cells_to|_motions/ { table = 1 }
         !table { print } /^};$/ { table = 0 }' |
    grep -vE '^extern const'
}

"$rtac" build --contracts "$spec" -o "$scratch/sound" 2>/dev/null
proof=$scratch/sound/${name}_proof.c kernel=$scratch/sound/${name}_kernel.c
# Tables that are declared alone: nothing is linked.
"$cc" -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -c -o "$scratch/proof.o" "$proof" ||
  breach 'the kernel with contracts does not compile'
diff <(code "$kernel") <(code "$proof") >"$scratch/diff" ||
  breach "contracts have changed code: $(head -20 "$scratch/diff")"

(($(contracts "$proof" | grep -c 'ensures') > 100)) || breach 'there are hardly any contracts'
for clause in 'ensures priority:' 'ensures advanced:' 'assert rule_5_' 'ensures declared_radius:'; do
  contracts "$proof" | grep -qF "$clause" || breach "there is no \`$clause\`"
done
! grep -n 'admit \|axiom [a-z_]*:' "$proof" | grep -vE 'axiom (same_side|leg_of_place):' ||
  breach 'an axiom that compiler/docs/kernel_proof.md does not list'

# Nothing is without a contract, and what is taken for granted is so for a reason that is explained;
# of the drone study it is nothing that puts a decision together.
! grep '^/\* gap: ' "$proof" || breach 'functions without contract, or properties that none states'
page=$(dirname -- "$0")/../../../compiler/docs/kernel_proof.md
reasons=$(sed -n 's|^/\* held: [A-Za-z0-9_]*: \(.*\) \*/$|\1|p' "$proof" | LC_ALL=C sort -u)
for reason in $reasons; do
  grep -q "^| $reason |" "$page" || breach "compiler/docs/kernel_proof.md does not explain \`$reason\`"
done
case $name in
  drone_surveillance) known=$'distances\nroots' ;;
  robot_delivery) known=$'applications\ndistances\nfleet\nroots\ntables' ;;
esac
[[ $reasons == "$known" ]] || breach "it takes more, or less, for granted than it did: $reasons"
proved=(_init _look _measure _report mode_step monitor_step reach_of estimate_of)
[[ $name == robot_delivery ]] || proved+=(_check _step)
for function in "${proved[@]}"; do
  ! grep -qE "^/\* held: [a-z_]*$function: " "$proof" || breach "$function is taken for granted"
done

for mutant in or-for-and lowest-priority-drives half-look-ahead no-radius; do
  "$rtac" build --contracts --mutate "$mutant" "$spec" -o "$scratch/$mutant" 2>/dev/null
  diff <(contracts "$proof") <(contracts "$scratch/$mutant/${name}_proof.c") >"$scratch/diff" ||
    ! grep -q '^<' "$scratch/diff" || # it may take further functions of the library, with theirs
    breach "$mutant has other contracts: $(head -20 "$scratch/diff")"
  ! diff -q <(code "$proof") <(code "$scratch/$mutant/${name}_proof.c") >/dev/null ||
    breach "$mutant has the same code"
done

# A drone 1 cm wider; a delivery robot likewise.
mkdir -p "$scratch/wider"
cp -- "$(dirname -- "$spec")"/*.rta "$scratch/wider"
sed -i 's/body     radius 8 cm;/body     radius 9 cm;/; s/body     radius 11 cm;/body     radius 12 cm;/' \
  "$scratch/wider"/*.rta
"$rtac" build --contracts "$scratch/wider/$name.rta" -o "$scratch/wider/out" 2>/dev/null
! diff -q <(contracts "$proof") <(contracts "$scratch/wider/out/${name}_proof.c") >/dev/null ||
  breach 'another body has the same contracts'

((failures == 0))
