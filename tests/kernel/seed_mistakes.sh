#!/bin/sh
# Seeds one mistake at a time in texts of kernels and asks whether the tests notice. Sourced by the
# mutants.sh of each kernel, which defines
#   build FOLDER   compiles the texts of that folder into $work/mutant.so
#   passes         runs the tests against it, with their output in $work/log
# seed_mistakes MUTANTS WORK_DIRECTORY FOLDER TEXT...: MUTANTS has lines of a name and a sed
# expression. Fails when a mistake goes unnoticed, or is no longer found in any text. Mistakes may
# take turns (tests/turn.sh).

# shellcheck source=tests/turn.sh
. "${0%/tests/*}/tests/turn.sh"

# seeded EDIT FOLDER TEXT...: writes the texts with the mistake to $work; fails when it is in none.
seeded() {
  edit=$1 folder=$2 found=1
  shift 2
  for text; do
    sed -E "$edit" "$folder/$text" >"$work/$text"
    cmp -s "$folder/$text" "$work/$text" || found=0
  done
  return "$found"
}

seed_mistakes() {
  mutants=$1 work=$2 folder=$3 killed=0 wrong=0 number=0
  shift 3
  mkdir -p "$work"
  build "$folder" || { echo "the kernel itself does not compile"; return 1; }
  passes || { echo "the kernel itself fails:"; cat "$work/log"; return 1; }
  while read -r name expression; do
    case $name in '' | '#'*) continue ;; esac
    number=$((number + 1))
    is_due $number || continue
    if ! seeded "$expression" "$folder" "$@"; then
      echo "$name: the expression matches nothing any more"
      wrong=$((wrong + 1))
    elif ! build "$work"; then
      echo "$name: does not compile"
      wrong=$((wrong + 1))
    elif passes; then
      echo "$name: NOT NOTICED"
      wrong=$((wrong + 1))
    else
      killed=$((killed + 1))
      echo "$name: noticed by $(sed -n 's/^\[  FAILED  \] \([A-Za-z0-9_.\/]*\).*/\1/p' "$work/log" | head -1)"
    fi
  done <"$mutants"
  echo "$killed of $number mistakes noticed, $wrong not"
  [ "$wrong" -eq 0 ] && [ "$number" -ge 10 ] && [ "$killed" -ge 1 ]
}
