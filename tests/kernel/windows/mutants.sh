#!/bin/sh
# The tests of zones that come and go must notice every mistake that is seeded in their kernel.
# Usage: mutants.sh COMPILER KERNEL_TEXT INCLUDE_DIRECTORY TEST_PROGRAM WORK_DIRECTORY
set -u
compiler=$1 kernel=$2 include=$3 program=$4 work=$5
here=$(dirname "$0")
text=$(basename "$kernel")

# The tests' view of the kernel, as a library that goes before the true one.
build() {
  "$compiler" -std=c99 -O1 -w -fPIC -shared -I"$include" -I"$here" \
    -DWINDOWS_KERNEL_TEXT="\"$1/$text\"" "$here/windows_probe.c" -o "$work/mutant.so"
}
passes() {
  LD_PRELOAD="$work/mutant.so" timeout 60 "$program" --gtest_brief=1 --gtest_fail_fast \
    >"$work/log" 2>&1
}

# shellcheck source=tests/kernel/seed_mistakes.sh
. "$here/../seed_mistakes.sh"
seed_mistakes "$here/mutants.txt" "$work" "$(dirname "$kernel")" "$text"
