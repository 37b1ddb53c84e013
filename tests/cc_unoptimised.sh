#!/bin/sh
# The C compiler of tests whose kernels take few steps: optimising them would take most of the time.
# The last of several -O counts.
exec cc "$@" -O0
