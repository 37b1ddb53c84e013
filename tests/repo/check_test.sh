#!/usr/bin/env bash
# Each check of the repository accepts a good tree and refuses one with a single breach: a check
# that cannot fail protects nothing.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
tree="$scratch/a tree"
failures=0

good_tree() {
  rm -rf -- "$tree"
  mkdir -p "$tree"/{compiler/{support,geometry,diagnostics,codegen},runtime/core,specs,examples/one,tests}
  printf '#include <string>\n#include "compiler/support/b.h"\n' >"$tree/compiler/support/a.cpp"
  printf '#include <CGAL/Gmpq.h>\n' >"$tree/compiler/geometry/a.cpp"
  printf '#include "rtac/types.h"\n#include "near.h"\n' >"$tree/runtime/core/a.cpp"
  printf '#include "rtac/sim/world.h"\n#include "one_system.h"\n' >"$tree/examples/one/main.cpp"
  printf 'see [the code](compiler/support/a.cpp), ./dev demo, ./dev test\n' >"$tree/README.md"
  printf '  demo) ;;\n  test) ;;\n' >"$tree/dev"
  mkdir -p "$tree/runtime/include/rtac"
  printf 'set(RTAC_ABI 7)\n' >"$tree/CMakeLists.txt"
  printf 'inline constexpr int abi = 7;\n' >"$tree/runtime/include/rtac/kernel_bridge.h"
  mkdir -p "$tree/tests/golden/one/expected" "$tree/tests/compiler"
  mkdir -p "$tree/compiler/docs" "$tree/tests/campaign/specs/templates"
  printf 'spec a;\n' >"$tree/tests/campaign/specs/templates/brake_point.rta"
  printf 'template seeds violations hash\nbrake_point 1-100000 0  0123456789abcdef\n' \
    >"$tree/tests/campaign/summary.txt"
  printf '## Rule 1: one\n\n### Rule 1.1 first\n' >"$tree/compiler/docs/language.md"
  printf 'TEST(Rule1, Holds) {}\nTEST_F(Rule1_1, Holds) {}\n' >"$tree/tests/rules_test.cpp"
  local block phase shown="$tree/tests/golden/one/expected/transcript.txt"
  for phase in 1:syntax 2:names 3:types 4:geometry 5:timing 6:arbitration 7:codegen 9:driver; do
    block=${phase%%:*} phase=${phase##*:}
    printf 'RTAC_DIAGNOSTIC(%d001, %s_one, error,\n  "text")\n' "$block" "$phase" \
      >"$tree/compiler/diagnostics/codes_$phase.def"
    printf '#include "compiler/diagnostics/codes_%s.def"\n' "$phase" \
      >>"$tree/compiler/diagnostics/codes.def"
    printf 'error[%d001]: text\nhelp: try\n\n' "$block" >>"$shown"
  done
}

accepts() { # CHECK
  bash "$here/check.sh" "$1" "$tree" >"$scratch/log" 2>&1 || {
    printf 'check %s refuses the good tree:\n' "$1"
    cat -- "$scratch/log"
    failures=$((failures + 1))
  }
}

refuses() { # CHECK EXPECTED_TEXT
  if bash "$here/check.sh" "$1" "$tree" >"$scratch/log" 2>&1 || ! grep -qF -- "$2" "$scratch/log"; then
    printf 'check %s does not report "%s":\n' "$1" "$2"
    cat -- "$scratch/log"
    failures=$((failures + 1))
  fi
  good_tree
}

good_tree
for check in includes examples length layout paths leftovers readme links codes tested helps rules abi \
  campaign; do
  accepts "$check"
done

printf '#include "rtac/types.h"\n' >>"$tree/compiler/support/a.cpp"
refuses includes 'compiler/support may not include runtime/include/rtac'
printf '#include "compiler/support/b.h"\n' >>"$tree/runtime/core/a.cpp"
refuses includes 'runtime/core may not include compiler/support'
printf '#include "compiler/codegen/print.h"\n' >>"$tree/compiler/geometry/a.cpp"
refuses includes 'compiler/geometry may not include compiler/codegen'
printf '  #  include <CGAL/Gmpq.h>\n' >>"$tree/compiler/support/a.cpp"
refuses includes 'compiler/support may not include CGAL'
printf '#include <ompl/util/Console.h>\n' >>"$tree/runtime/core/a.cpp"
refuses includes 'runtime/core may not include OMPL'
printf '#include <coin/IpTNLP.hpp>\n' >>"$tree/runtime/core/a.cpp"
refuses includes 'runtime/core may not include Ipopt'
printf '#include "rtac/sim/world.h"\n' >>"$tree/runtime/core/a.cpp"
refuses includes 'runtime/core may not include runtime/include/rtac/sim'
printf '#include "../support/b.h"\n' >>"$tree/compiler/geometry/a.cpp"
refuses includes 'a path with ..'
mkdir "$tree/compiler/new" && printf '\n' >"$tree/compiler/new/a.cpp"
refuses includes 'no line in tests/repo/include_rules.txt'
printf 'target_link_libraries(one rtac_core)\n' >"$tree/examples/one/CMakeLists.txt"
refuses examples 'rtac_core'
printf '#include "runtime/include/rtac/types.h"\n' >>"$tree/examples/one/main.cpp"
refuses examples 'main.cpp:3'
printf '%801s' '' | tr ' ' '\n' >"$tree/compiler/support/long.cpp"
refuses length 'long.cpp: 801 lines'
mkdir "$tree/scripts" && printf '\n' >"$tree/scripts/a.sh"
refuses layout 'scripts'
printf 'cd /%s/rtac\n' home >"$tree/specs/notes.md"
refuses paths 'specs/notes.md:1'
printf '// TO%s: later\n' DO >"$tree/runtime/core/b.cpp"
refuses leftovers 'b.cpp:1'
printf './dev demo\n' >"$tree/README.md"
refuses readme "./dev test"
printf './dev demo, ./dev test, ./dev fly\n' >"$tree/README.md"
refuses readme "./dev fly"
# shellcheck disable=SC2016  # the back-ticks are those of the page
printf './dev demo, ./dev test\n```cpp specs/notes.md\nint x;\n```\n' >"$tree/README.md"
refuses readme 'README.md: the quotation is not in specs/notes.md'
printf './dev demo, ./dev test\n' >"$tree/README.md"
mkdir -p "$tree/compiler/docs"
# shellcheck disable=SC2016  # here as well
printf '```cpp specs/notes.md\nint x;\n```\n' >"$tree/compiler/docs/application.md"
refuses readme 'application.md: the quotation is not in specs/notes.md'
printf '[x](nowhere.md)\n' >"$tree/specs/notes.md"
refuses links 'nowhere.md'
printf 'RTAC_DIAGNOSTIC(2001, again, error, "text")\n' >>"$tree/compiler/diagnostics/codes_names.def"
refuses codes 'given twice: 2001'
printf 'RTAC_DIAGNOSTIC(2002, names_one, error, "text")\n' >>"$tree/compiler/diagnostics/codes_names.def"
refuses codes 'given twice: names_one'
printf 'RTAC_DIAGNOSTIC(3002, stray, error, "text")\n' >>"$tree/compiler/diagnostics/codes_names.def"
refuses codes '3002 is outside the block'
sed -i '/syntax/d' "$tree/compiler/diagnostics/codes.def"
refuses codes 'does not include'
printf 'RTAC_DIAGNOSTIC(2002, unseen, error, "text")\n' >>"$tree/compiler/diagnostics/codes_names.def"
refuses tested 'no test provokes 2002, unseen'
printf '$ rtac check a\nerror[2001]: text\n\n1 error\n' >"$tree/tests/golden/one/expected/transcript.txt"
refuses helps 'error[2001]: text'
printf 'error[2001]: a\nerror[3001]: b\nhelp: try\n' >"$tree/tests/golden/one/expected/transcript.txt"
refuses helps 'error[2001]: a'
printf 'set(RTAC_ABI 8)\n' >"$tree/CMakeLists.txt"
refuses abi 'abi is '
printf '### Rule 1.2 second\n' >>"$tree/compiler/docs/language.md"
refuses rules 'no test is called Rule1_2'
printf 'TEST(Rule3, Holds) {}\n' >>"$tree/tests/rules_test.cpp"
refuses rules 'Rule3 is no rule'

sed -i 's/100000 0/100000 1/' "$tree/tests/campaign/summary.txt"
refuses campaign 'not of a whole summary without violations'
sed -i 's/100000 0/97500 0/' "$tree/tests/campaign/summary.txt"
refuses campaign 'not of a whole summary without violations'
printf 'spec b;\n' >"$tree/tests/campaign/specs/templates/land_space.rta"
refuses campaign 'land_space is not in it once'

((failures == 0)) && printf 'every check can fail\n'
