#!/usr/bin/env bash
# ./dev on machines other than this one: stand-ins for the package tools play a machine where
# everything is installed, one without network, and one without root.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
chmod 755 "$scratch"
mkdir -p "$scratch/a place" "$scratch/bin" "$scratch/elsewhere"
cp -- "$here/../../dev" "$scratch/a place/dev"
failures=0

stand_in() { # NAME SCRIPT
  printf '#!/bin/bash\n%s\n' "$2" >"$scratch/bin/$1"
  chmod 755 "$scratch/bin/$1"
}

expect() { # WHAT EXIT_CODE TEXT COMMAND...
  local what=$1 code=$2 text=$3 status=0
  shift 3
  (cd -- "$scratch/elsewhere" && "$@") </dev/null >"$scratch/log" 2>&1 || status=$?
  if ((status != code)) || ! grep -qF -- "$text" "$scratch/log"; then
    printf '%s: exit code %d, not %d, or no text "%s":\n' "$what" "$status" "$code" "$text"
    cat -- "$scratch/log"
    failures=$((failures + 1))
  fi
}

dev=(env "PATH=$scratch/bin:/usr/bin:/bin" bash "$scratch/a place/dev")
as_nobody=()
if ((EUID == 0)); then
  as_nobody=(setpriv --reuid 65534 --clear-groups)
fi

expect 'no command' 2 'usage: ./dev' "${dev[@]}"
expect 'unknown command' 2 'unknown command' "${dev[@]}" fly
# Arguments that no command takes are refused at once: these end without a tool at hand.
expect 'demo with an argument' 2 'takes no arguments' "${dev[@]}" demo extra
expect 'setup with an argument' 2 'takes no arguments' "${dev[@]}" setup extra
expect 'help with an argument' 2 'takes no arguments' "${dev[@]}" help extra
# shellcheck disable=SC2016  # back-ticks of the message
expect 'lint of a file that is not there' 2 'there is no file `nofile`' "${dev[@]}" lint nofile
expect 'lint of another kind of file' 2 'no C or C++ source' "${dev[@]}" lint dev
expect 'lint by no turn' 2 'is no turn, such as 1/4' env RTAC_TURN=x "${dev[@]}" lint
expect 'lint by a turn too many' 2 'is no turn, such as 1/4' env RTAC_TURN=4/4 "${dev[@]}" lint
# shellcheck disable=SC2016  # back-ticks of the message
expect 'bless of an unknown case' 2 'no golden case is called `nocase`' "${dev[@]}" bless nocase
expect 'bless of an empty name' 2 'no golden case is called' "${dev[@]}" bless ''
# shellcheck disable=SC2016  # back-ticks of the message
{
  expect 'fuzz for no time' 2 '`0` is no number of seconds' "${dev[@]}" fuzz 0
  expect 'fuzz for too short a time' 2 '`3` is no number of seconds' "${dev[@]}" fuzz 3
  expect 'fuzz for a word' 2 '`long` is no number of seconds' "${dev[@]}" fuzz long
}
expect 'fuzz with two times' 2 'takes one number of seconds' "${dev[@]}" fuzz 60 60
# shellcheck disable=SC2016  # back-ticks of the message
expect 'campaign of nothing' 2 '`campaign 0`: not a number of runs' "${dev[@]}" campaign 0
# shellcheck disable=SC2016  # back-ticks of the message
expect 'proof of nothing' 2 'there is no specification `nofile.rta`' "${dev[@]}" prove nofile.rta
for command in setup demo test bench campaign prove bless fuzz lint; do
  expect 'help' 0 "  $command " "${dev[@]}" --help
done

# shellcheck disable=SC2016  # the scripts expand their own arguments
{
  stand_in apt-get 'echo "apt-get was called"; exit 100'
  stand_in sudo 'echo "sudo was called"; exit 1'
  stand_in dpkg-query 'for name in "${@:3}"; do echo "$name installed"; done'
}
expect 'everything is installed' 0 'stage install' "${as_nobody[@]}" "${dev[@]}" setup
if grep -q 'was called' "$scratch/log"; then
  printf 'setup wants root although nothing is missing\n'
  failures=$((failures + 1))
fi

stand_in dpkg-query 'exit 1'
expect 'no password-less sudo' 3 'sudo asks for a password' "${as_nobody[@]}" "${dev[@]}" setup
if ((EUID == 0)); then
  expect 'no network' 3 'cannot reach the package archives' "${dev[@]}" setup
fi
# A PATH with just the tools that the script needs plays a machine without sudo.
mkdir "$scratch/few"
for tool in bash dirname readlink grep cat env; do
  ln -s "$(command -v "$tool")" "$scratch/few/$tool"
done
ln -s ../bin/dpkg-query "$scratch/few/dpkg-query"
expect 'neither root nor sudo' 3 'needs root or sudo' \
  "${as_nobody[@]}" env "PATH=$scratch/few" bash "$scratch/a place/dev" setup

((failures == 0)) && printf 'ok\n'
