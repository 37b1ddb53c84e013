#!/usr/bin/env bash
# compile.sh INCLUDE CHUNK CHUNKS: all generated golden files compile without a warning, with GCC
# and Clang: kernels as C99 and as C++17, wrappers and systems as C++17. CHUNK (from 0) of CHUNKS
# takes every CHUNKS-th case, so that several run beside each other. Both compilers must be there.
set -euo pipefail

include=$1 chunk=$2 chunks=$3
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
strict=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
failures=0

# Some warnings need the optimiser; the first case of each chunk is compiled with it.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

try() { # COMMAND...; prints it when it fails
  if ! "$@"; then
    printf 'failed: %s\n' "$*"
    failures=$((failures + 1))
  fi
}

compile_case() { # FOLDER MODE...; MODE: how far to compile
  local folder=$1 kernel stem
  shift
  kernel=$(find "$folder" -name '*_kernel.c')
  stem=${kernel%_kernel.c}
  # The system stands before all else, so that it includes what it needs itself.
  printf '#include "%s"\n' "$(basename -- "$stem")_system.h" "$stem.cpp" >"$work/whole.cpp"
  try gcc -std=c99 "${strict[@]}" "$@" "$kernel"
  try clang -std=c99 "${strict[@]}" "$@" "$kernel"
  local compiler
  for compiler in g++ clang++; do
    local cpp=("$compiler" -std=c++17 "${strict[@]}" -I "$include" -I "$folder" "$@")
    try "${cpp[@]}" -x c++ "$kernel"
    try "${cpp[@]}" "$work/whole.cpp"
  done
}

# The manifest says how large what is remembered is.
check_bytes() { # FOLDER
  local manifest prefix entry bytes
  manifest=$(find "$1" -name '*_manifest.json')
  prefix=$(sed -n 's/^typedef struct \(.*\)_monitors_state {$/\1/p' "$1"/*_kernel.h)
  for entry in '' verdicts_; do
    bytes=$(sed -n "/^  \"monitors\"/,\$ s/^    \"${entry}state_bytes\": \([0-9]*\),\$/\1/p" "$manifest")
    printf '#include "%s"\n' "$(find "$1" -name '*_kernel.h')"
    printf '_Static_assert(sizeof(%s_monitors_%sstate) == %s, "bytes");\n' "$prefix" "$entry" "$bytes"
  done >"$work/bytes.c"
  try gcc -std=c11 -fsyntax-only "$work/bytes.c"
}

number=0 compiled=0
for folder in "$here"/*/expected/generated; do
  if ((number % chunks == chunk)); then
    mode=(-fsyntax-only)
    if ((compiled == 0)); then mode=(-O2 -c -o "$work/object.o"); fi
    compile_case "$folder" "${mode[@]}"
    if grep -q '_monitors_state {' "$folder"/*_kernel.h; then check_bytes "$folder"; fi
    compiled=$((compiled + 1))
  fi
  number=$((number + 1))
done

printf '%d of %d cases\n' "$compiled" "$number"
((compiled > 0 && failures == 0))
