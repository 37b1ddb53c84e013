#!/bin/sh
# The C compiler of tests that ask the model checker: most of their models are alike, and ccache,
# where there is one, compiles each of them once.
if command -v ccache >/dev/null; then exec ccache cc "$@"; fi
exec cc "$@"
