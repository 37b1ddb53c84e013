#!/bin/sh
# What tests/turn.h does, for scripts. Sourced by them.
# is_due NUMBER: whether the case of this number is looked at.
is_due() {
  case ${RTAC_TURN:-0/1} in
    [0-9]*/[1-9]*) [ $(($1 % ${RTAC_TURN#*/})) -eq "${RTAC_TURN%/*}" ] ;;
    *) echo "RTAC_TURN=$RTAC_TURN" >&2 && exit 1 ;;
  esac
}
