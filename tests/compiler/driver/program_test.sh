#!/usr/bin/env bash
# program_test.sh RTAC ROOT: the program itself, as a shell sees it: standard input, streams, colour,
# exit codes, and the same bytes from two processes that have nothing in common.
set -euo pipefail

rtac=$1 root=$2
spec=$root/specs/robot_delivery/robot_delivery.rta
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
failures=0

expect() { # TEXT CONDITION...
  local text=$1
  shift
  if ! "$@"; then
    printf 'failed: %s\n' "$text"
    failures=$((failures + 1))
  fi
}
exits() { # CODE COMMAND...; streams go to out and err
  local code=$1 status=0
  shift
  "$@" >"$work/out" 2>"$work/err" || status=$?
  expect "exit $code (was $status): $*" test "$status" = "$code"
}

exits 0 "$rtac" help
expect 'help goes to stdout' test -s "$work/out"
expect 'help leaves stderr empty' test ! -s "$work/err"
exits 2 "$rtac"
exits 2 "$rtac" check --no-such-flag
exits 2 "$rtac" check "$work/missing.rta"
exits 2 "$rtac" check "$work"
exits 0 "$rtac" check "$spec"

# Standard input has no name; places in it still have lines and columns.
exits 0 "$rtac" check - <"$spec"
printf 'spec a;\nzone z = rectangle (0, 0 m) to (1 m, 1 m);\n' >"$work/faulty.rta"
exits 1 "$rtac" check - <"$work/faulty.rta"
expect 'a place in standard input' grep -q -- '--> <stdin>:2:21' "$work/err"
exits 0 "$rtac" build - -o "$work/stdin" <"$spec"
expect 'files are named after the specification' test -s "$work/stdin/robot_delivery_kernel.c"

# A closed or unreadable standard input is no empty specification.
exits 2 "$rtac" check - <&-
expect 'a closed standard input' grep -q 'error\[9002\]: cannot read standard input' "$work/err"
exits 2 "$rtac" check - <"$work"
exits 1 "$rtac" check - </dev/null

# What may not be read or written, unless root may.
printf 'spec a;\n' >"$work/secret.rta"
mkdir "$work/locked"
chmod 000 "$work/secret.rta" "$work/locked"
if ((EUID == 0)); then
  as_nobody=(setpriv --reuid 65534 --clear-groups)
  chmod 755 "$work"
else
  as_nobody=()
fi
if ${as_nobody[@]+"${as_nobody[@]}"} test -x "$rtac" -a -r "$spec"; then
  exits 2 ${as_nobody[@]+"${as_nobody[@]}"} "$rtac" check "$work/secret.rta"
  expect 'an unreadable file' grep -qi 'permission denied' "$work/err"
  exits 2 ${as_nobody[@]+"${as_nobody[@]}"} "$rtac" check "$work/locked/a.rta"
  expect 'an unreadable directory' grep -qi 'permission denied' "$work/err"
  exits 2 ${as_nobody[@]+"${as_nobody[@]}"} "$rtac" build "$spec" -o "$work/locked"
  expect 'an unwritable directory' grep -qi 'permission denied' "$work/err"
fi

# No colour without a terminal, whatever the environment says.
exits 1 env TERM=xterm-256color CLICOLOR_FORCE=1 "$rtac" check "$work/faulty.rta"
expect 'no escapes in a file' test -z "$(grep -l $'\033' "$work/err" || true)"
if command -v script >/dev/null; then
  script -qec "'$rtac' check '$work/faulty.rta'" /dev/null >"$work/tty" </dev/null || true
  expect 'colour on a terminal' grep -q $'\033' "$work/tty"
  NO_COLOR=1 script -qec "'$rtac' check '$work/faulty.rta'" /dev/null >"$work/tty" </dev/null || true
  expect 'NO_COLOR is obeyed' test -z "$(grep -l $'\033' "$work/tty" || true)"
fi

# A full disk: the message says so, nothing stays behind.
if [[ -w /dev/full ]]; then
  status=0
  "$rtac" help >/dev/full 2>"$work/err" || status=$?
  expect 'a full disk does not look like success' test "$status" != 0
  "$rtac" check --format json "$spec" >/dev/full 2>"$work/err" || status=$?
  expect 'a full disk is exit code 2' test "$status" = 2
  expect 'a full disk is told in the format that is asked for, once' \
    test "$(grep -c 'cannot write to' "$work/err") $(grep -c '^error' "$work/err")" = '1 0'
  exits 2 "$rtac" build "$spec" -o "$work/full" --depfile /dev/full
  # shellcheck disable=SC2016  # back-ticks of the message
  expect 'a full disk is named' grep -q 'cannot write `/dev/full`: No space left' "$work/err"
  expect 'a device stays a device' test -c /dev/full
fi

mkdir -p "$work/one" "$work/two/deeper"
(cd "$work/one" && env -i PATH="$PATH" LANG=C TZ=UTC HOME=/ "$rtac" build "$spec" -o out)
(cd "$work/two/deeper" && env LANG=de_DE.UTF-8 LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo HOME=/nowhere \
  PADDING="$(printf '%4000s' x)" "$rtac" build "$spec" -o out/..//out)
expect 'two builds give the same bytes' diff -r "$work/one/out" "$work/two/deeper/out"
expect 'no path of this machine' test -z "$(grep -rlF -e "$root" -e "$work" "$work/one/out" || true)"

((failures == 0))
