#!/bin/sh
# The tests of the generated kernel must notice every mistake that is seeded in it.
# Usage: mutants.sh COMPILER KERNEL_TEXT INCLUDE_DIRECTORY TEST_PROGRAM WORK_DIRECTORY
set -u
compiler=$1 kernel=$2 include=$3 program=$4 work=$5
here=$(dirname "$0")
text=$(basename "$kernel")
# what takes milliseconds goes first: it notices most
slow='Course.*:Reach.*:PairAhead.*:EnergyAhead.*:Hostile.*:Rule10.NoPlaceFlapsUnderNoise:SegmentBoundary.*'

# The tests' view of the kernel, as a library that goes before the true one.
build() {
  "$compiler" -std=c99 -O1 -w -fPIC -shared -I"$include" -I"$here" \
    -DPROBE_KERNEL_TEXT="\"$1/$text\"" "$here/kernel_probe.c" -o "$work/mutant.so"
}
run() {
  LD_PRELOAD="$work/mutant.so" timeout 60 "$program" --gtest_brief=1 --gtest_fail_fast \
    --gtest_filter="$1" >"$work/log" 2>&1
}
passes() {
  run "-$slow" && run "$slow"
}

# shellcheck source=tests/kernel/seed_mistakes.sh
. "$here/seed_mistakes.sh"
seed_mistakes "$here/mutants.txt" "$work" "$(dirname "$kernel")" "$text"
