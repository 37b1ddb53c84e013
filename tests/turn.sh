#!/bin/sh
# What tests/turn.h does, for scripts. Sourced by them.
# is_due NUMBER: whether the case of this number is looked at.
is_due() {
  turn=${RTAC_TURN:-0/1}
  case $turn in
    [0-9]*/[1-9]*)
      [ "${turn%/*}" -lt "${turn#*/}" ] || { echo "RTAC_TURN=$turn" >&2 && exit 1; }
      [ $(($1 % ${turn#*/})) -eq "${turn%/*}" ]
      ;;
    *) echo "RTAC_TURN=$turn" >&2 && exit 1 ;;
  esac
}
