#!/usr/bin/env bash
# One lemma of compiler/verify/lemmas: z3 refutes the negated claim of every step; the hypotheses of
# every step can be met, so that it says something; every seeded mistake, a sed expression, makes a
# step fail, and no step is without one; and the code that it speaks of still reads as quoted.
# Usage: lemma_test.sh LEMMA.smt2 ROOT
set -euo pipefail

lemma=${1:?a lemma is needed} root=${2:?the root of the repository is needed}
readonly limit_s=60 # a step takes milliseconds, the slowest a second; machines may be busy
failures=0

report() {
  printf '%s: %s\n' "$lemma" "$*"
  failures=$((failures + 1))
}

if ! command -v z3 >/dev/null; then
  printf 'there is no z3, which proves the lemmas; this works: apt-get install z3, or ./dev setup\n'
  exit 1
fi

# One line a check. What z3 complains about is no answer.
answers() { # < SCRIPT
  z3 -T:$limit_s -in 2>&1 || true
}

# A claim is what stands from its mark to the check.
hypotheses() { # < SCRIPT
  sed '/^; claim$/,/^(check-sat)$/{/^(check-sat)$/!d}'
}

steps=() # their texts, as scripts of their own
while IFS= read -r line; do
  if [[ $line == '; step: '* ]]; then
    steps+=('')
  fi
  if ((${#steps[@]} > 0)); then
    steps[-1]+=$line$'\n'
  fi
done <"$lemma"

title() { # STEP
  sed -n '1s/^; step: //p' <<<"$1"
}

mapfile -t mistakes < <(sed -n 's/^; mistake: //p' "$lemma")
mapfile -t proved < <(answers <"$lemma")
mapfile -t met < <(hypotheses <"$lemma" | answers)

for mark in '; claim' '(check-sat)' '(reset)'; do
  found=$(grep -cxF -- "$mark" "$lemma" || true)
  if ((${#steps[@]} == 0 || found != ${#steps[@]})); then
    report "${#steps[@]} steps, but $found times \`$mark\`; each step has one"
  fi
done
name=$(basename -- "$lemma" .smt2)
grep -qxF "; lemma: $name" "$lemma" || report "does not begin with \`; lemma: $name\`"

for i in "${!steps[@]}"; do
  [[ ${proved[i]:-nothing} == unsat ]] ||
    report "not proved (${proved[i]:-nothing}): $(title "${steps[i]}")"
  [[ ${met[i]:-nothing} == sat ]] ||
    report "hypotheses not met (${met[i]:-nothing}): $(title "${steps[i]}")"
done
((${#proved[@]} == ${#steps[@]})) || report "z3 says more: ${proved[*]}"

broken=() # by some mistake, of the steps
for mistake in ${mistakes[@]+"${mistakes[@]}"}; do
  changed=0 noticed=''
  for i in "${!steps[@]}"; do
    wrong=$(sed "/^; mistake: /!{$mistake
}" <<<"${steps[i]}")
    [[ $wrong != "$(cat <<<"${steps[i]}")" ]] || continue
    changed=1
    answer=$(answers <<<"$wrong")
    if [[ $answer == sat ]]; then
      noticed=$answer broken[i]=1
    fi
  done
  if ((!changed)); then
    report "this mistake changes nothing: $mistake"
  elif [[ -z $noticed ]]; then
    report "nobody notices: $mistake"
  fi
done
for i in "${!steps[@]}"; do
  [[ -n ${broken[i]:-} ]] || report "no mistake breaks: $(title "${steps[i]}")"
done

# Code is quoted without its line breaks and indentation.
squeeze() {
  tr -s ' \n' ' ' | sed 's/^ //; s/ $//'
}
while IFS= read -r quotation; do
  file=${quotation%% | *} text=${quotation#* | }
  if [[ ! -f $root/$file ]]; then
    report "quotes $file, which is not there"
  elif [[ $(squeeze <"$root/$file") != *"$(squeeze <<<"$text")"* ]]; then
    report "$file does not read like this any more; does the lemma still hold of it? $text"
  fi
done < <(sed -n 's/^; code: //p' "$lemma")

((failures == 0))
