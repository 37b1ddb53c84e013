#!/bin/sh
# The tests of zones must notice every mistake that is seeded in what the kernel asks of them.
# Usage: mutants.sh COMPILER edges|cells LIBRARY_TEXT TEST_PROGRAM WORK_DIRECTORY
set -u
compiler=$1 kind=$2 library=$3 program=$4 work=$5
here=$(dirname "$0")
text=$(basename "$library")
trees=
[ "$kind" = cells ] && trees=-DPROBE_TREES

build() {
  "$compiler" -std=c99 -O1 -w -fPIC -shared -I"$1" -I"$here" -DPROBE_LIBRARY="\"$text\"" $trees \
    "$here/zone_probe.c" -o "$work/mutant.so"
}
run() {
  LD_PRELOAD="$work/mutant.so" timeout 200 "$program" --gtest_brief=1 --gtest_fail_fast \
    --gtest_filter="$1" >"$work/log" 2>&1
}
# small zones notice most
passes() {
  run '-*LargeZones*' && run '*LargeZones*'
}

# shellcheck source=tests/kernel/seed_mistakes.sh
. "$here/../seed_mistakes.sh"
seed_mistakes "$here/mutants_$kind.txt" "$work" "$(dirname "$library")" "$text"
