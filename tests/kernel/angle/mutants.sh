#!/bin/sh
# The tests of sines and cosines must notice every mistake that is seeded in them.
# Usage: mutants.sh COMPILER KERNEL_FOLDER TEST_PROGRAM WORK_DIRECTORY
set -u
compiler=$1 kernel=$2 program=$3 work=$4
here=$(dirname "$0")

build() {
  "$compiler" -std=c99 -O1 -w -fPIC -shared -I"$1" -I"$kernel" \
    "$here/angle_probe.c" -o "$work/mutant.so"
}
passes() {
  LD_PRELOAD="$work/mutant.so" timeout 60 "$program" --gtest_brief=1 --gtest_fail_fast \
    >"$work/log" 2>&1
}

# shellcheck source=tests/kernel/seed_mistakes.sh
. "$here/../seed_mistakes.sh"
seed_mistakes "$here/mutants.txt" "$work" "$kernel" angle.c
