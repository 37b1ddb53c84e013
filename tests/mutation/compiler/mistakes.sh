#!/bin/sh
# The tests of the compiler must notice every mistake that is seeded in it.
# Usage: mistakes.sh MISTAKES TEST_PROGRAM
set -u
mistakes=$1 program=$2 noticed=0 wrong=0 number=0
# shellcheck source=tests/turn.sh
. "${0%/tests/*}/tests/turn.sh"
log=$(mktemp)
trap 'rm -f "$log"' EXIT

passes() { # MISTAKE: with it, or none
  RTAC_MISTAKE=$1 timeout 20 "$program" --gtest_brief=1 --gtest_fail_fast >"$log" 2>&1
}

passes '' || { echo 'the compiler itself fails:'; cat "$log"; exit 1; }
while read -r name _; do
  case $name in '' | '#'*) continue ;; esac
  number=$((number + 1))
  is_due $number || continue
  if passes "$name"; then
    echo "$name: NOT NOTICED"
    wrong=$((wrong + 1))
  else
    noticed=$((noticed + 1))
    echo "$name: noticed by $(sed -n 's/^\[  FAILED  \] \([A-Za-z0-9_.\/]*\).*/\1/p' "$log" | head -1)"
  fi
done <"$mistakes"
echo "$noticed of $number mistakes noticed, $wrong not"
[ "$wrong" -eq 0 ] && [ "$number" -ge 30 ] && [ "$noticed" -ge 1 ]
