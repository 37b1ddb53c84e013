#!/bin/sh
# A source of the compiler with the mistakes of a file in it, each of which is made when the
# environment names it (seeded.h). Fails when one of their expressions is not there any more.
# Usage: seed.sh MISTAKES FILE SOURCE OUTPUT; FILE is what MISTAKES call the source
set -u
awk -v file="$2" -v mistakes="$1" '
  # All places; text is literal, and what has been put in is not looked at again.
  function seeded(text, right, wrong, name,    at, done) {
    done = ""
    while ((at = index(text, right)) > 0) {
      done = done substr(text, 1, at - 1) "(::rtac::mutation::seeded(\"" name "\") ? (" wrong ") : (" \
        right "))"
      text = substr(text, at + length(right))
    }
    return done text
  }
  { text = text $0 "\n" }
  END {
    while ((getline line < mistakes) > 0) {
      if (split(line, part, " @ ") != 4 || part[2] != file) continue
      if (index(text, part[3]) == 0) {
        print part[1] ": `" part[3] "` is not in " file " any more" >"/dev/stderr"
        failed = 1
      }
      text = seeded(text, part[3], part[4], part[1])
    }
    printf "%s", text
    exit failed
  }' "$3" >"$4"
