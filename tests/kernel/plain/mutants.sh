#!/bin/sh
# The tests of a kernel of inputs must notice every mistake that is seeded in it.
# Usage: mutants.sh COMPILER KERNEL_TEXT INCLUDE_DIRECTORY TEST_PROGRAM WORK_DIRECTORY [MUTANTS
# [PROBE]]; PROBE: a C file that includes the text, so that its static functions can be called.
set -u
compiler=$1 kernel=$2 include=$3 program=$4 work=$5 probe=${7:-}
here=$(dirname "$0")
text=$(basename "$kernel")

# That kernel as a library that goes before the true one.
build() {
  "$compiler" -std=c99 -O1 -w -fPIC -shared -I"$include" \
    -DPROBE_KERNEL_TEXT="\"$1/$text\"" "${probe:-$1/$text}" -o "$work/mutant.so"
}
passes() {
  LD_PRELOAD="$work/mutant.so" timeout 20 "$program" --gtest_brief=1 --gtest_fail_fast \
    >"$work/log" 2>&1
}

# shellcheck source=tests/kernel/seed_mistakes.sh
. "$here/../seed_mistakes.sh"
seed_mistakes "${6:-$here/mutants.txt}" "$work" "$(dirname "$kernel")" "$text"
