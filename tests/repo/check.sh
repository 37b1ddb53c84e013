#!/usr/bin/env bash
# Rules about the repository itself. `check.sh CHECK [ROOT]` prints every breach as
# path[:line]: text, and exits 1 when there is one. check_test.sh shows that each check can fail.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
check=${1:?a check is needed}
cd -- "${2:-$here/../..}"

# What version control knows or would take; a tree without it is taken as it is.
files() { # PATTERN...
  if [[ $(git rev-parse --show-toplevel 2>/dev/null) == "$PWD" ]]; then
    git ls-files --cached --others --exclude-standard -- "$@"
  else
    local pattern
    for pattern in "$@"; do
      find . \( -path ./build -o -path ./out -o -path ./.git \) -prune -o -type f \
        -path "./$pattern" -print | sed 's|^\./||'
    done
  fi | LC_ALL=C sort -u | while IFS= read -r file; do
    if [[ -f $file ]]; then printf '%s\n' "$file"; fi # a deleted file is listed until it is committed
  done
}

breaches=0
breach() {
  printf '%s\n' "$*"
  breaches=$((breaches + 1))
}

# The folder table of compiler/docs/architecture.md, kept in include_rules.txt.
check_includes() {
  local list
  mapfile -t list < <(files '*.h' '*.c' '*.cpp' '*.ll' '*.yy')
  awk -f "$here/includes.awk" "$here/include_rules.txt" ${list[@]+"${list[@]}"} || breaches=1
}

# Examples are projects of an outside user: neither sources nor build files reach into the tree.
check_examples() {
  local list
  mapfile -t list < <(files 'examples/*.cpp' 'examples/*.h' 'examples/*.cmake' 'examples/*.txt')
  ((${#list[@]} > 0)) || return 0
  if grep -nE '(^|[^[:alnum:]_])(compiler|runtime)/|rtac_(folder|core|stack|sim|planning|optimize|cli)\>' \
    -- "${list[@]}" /dev/null; then
    breach 'examples name inner folders or targets; installed headers and rtac:: targets work'
  fi
}

check_length() {
  local file lines
  while IFS= read -r file; do
    [[ $file != *.md ]] || continue # a reference is one page
    lines=$(wc -l <"$file")
    if ((lines > 800)); then
      breach "$file: $lines lines; at most 800: split it"
    fi
  done < <(files 'compiler/*' 'runtime/*')
}

check_layout() {
  local top
  while IFS= read -r top; do
    case $top in
      compiler | runtime | specs | examples | tests | .*) ;;
      *) breach "$top: the top level has only compiler, runtime, specs, examples and tests" ;;
    esac
  done < <(files '*' | sed -n 's|^\([^/]*\)/.*|\1|p' | LC_ALL=C sort -u)
}

text_matches() { # PATTERN; prints matches in all text files
  local list
  mapfile -t list < <(files '*')
  grep -nIE "$1" -- ${list[@]+"${list[@]}"} /dev/null
}

check_paths() {
  if text_matches '(^|[^[:alnum:]_./}-])/(work|home|root|farm)(/|$|[^[:alnum:]_-])'; then
    breach 'absolute paths of one machine; paths relative to the repository work everywhere'
  fi
}

check_leftovers() {
  if text_matches '\<(T[O]DO|F[I]XME|X[X]X)\>'; then
    breach 'unfinished work marked in the text; finish it or describe the limit as it is'
  fi
}

# The commands that a reader is told to run exist.
check_readme() {
  local command
  if [[ ! -f README.md ]]; then
    breach 'README.md: missing'
    return
  fi
  for command in demo test; do
    grep -qF "./dev $command" README.md || breach "README.md: does not mention \`./dev $command\`"
  done
  while IFS= read -r command; do
    grep -qE "^  $command\)" dev || breach "README.md: \`./dev $command\` does not exist"
  done < <(grep -ohE '\./dev [a-z]+' README.md | sed 's|.* ||' | LC_ALL=C sort -u)
  check_quotes README.md
  if [[ -f compiler/docs/application.md ]]; then check_quotes compiler/docs/application.md; fi
}

# A block of code that names its file (```cpp examples/gate/main.cpp) stands there word for word, so
# that what a reader copies is what is compiled and run.
check_quotes() { # PAGE
  local line file='' block='' text
  while IFS= read -r line; do
    if [[ $line == '```'* ]]; then
      if [[ -n $file ]]; then
        text=$(cat -- "$file" 2>/dev/null || true)
        [[ $text == *"$block"* ]] || breach "$1: the quotation is not in $file"
      fi
      file='' block=''
      [[ $line =~ ^\`\`\`[a-z]+\ ([^ ]+)$ ]] && file=${BASH_REMATCH[1]}
    elif [[ -n $file ]]; then
      block+=${block:+$'\n'}$line
    fi
  done <"$1"
}

# A page without its examples and the code in its sentences.
prose() { # PAGE
  awk '/^```/ { code = !code; next } !code { gsub(/`[^`]*`/, ""); print }' "$1"
}

# Relative links between the pages lead somewhere.
check_links() {
  local page target
  while IFS= read -r page; do
    while IFS= read -r target; do
      if [[ $target != *:* && ! -e $(dirname -- "$page")/$target ]]; then
        breach "$page: the link to $target leads nowhere"
      fi
    done < <(prose "$page" | grep -oE '\]\([^)# ]+' | sed 's|^](||')
  done < <(files '*.md')
}

# Numbers of diagnostics: in the block of their phase, never given twice; so with their names.
check_codes() {
  local block phase file entries folder=compiler/diagnostics
  while read -r block phase; do
    file=$folder/codes_$phase.def
    grep -qF "\"$file\"" $folder/codes.def || breach "$folder/codes.def: does not include $file"
    entries=$(tr '\n' ' ' <"$file" | grep -oE 'RTAC_DIAGNOSTIC\( *[0-9]+' | grep -oE '[0-9]+$' || true)
    while IFS= read -r number; do
      [[ $number =~ ^${block}[0-9]{3}$ ]] ||
        breach "$file: $number is outside the block ${block}001 to ${block}999"
    done < <(printf '%s\n' "${entries:-${block}000}")
  done <<'TABLE'
1 syntax
2 names
3 types
4 geometry
5 timing
6 arbitration
7 codegen
9 driver
TABLE
  local twice
  twice=$(cat $folder/codes_*.def | tr '\n' ' ' |
    grep -oE 'RTAC_DIAGNOSTIC\( *[0-9]+, *[a-z0-9_]+' | sed 's/.*( *//; s/, */\n/' |
    LC_ALL=C sort | uniq -d)
  if [[ -n $twice ]]; then
    breach "$folder: given twice: $(tr '\n' ' ' <<<"$twice")"
  fi
}

# Every diagnostic is shown by a golden case, or a unit test names it: as Code::NAME, or as a test of
# that name.
check_tested() {
  local number name list
  mapfile -t list < <(files 'tests/compiler/*.cpp' 'tests/compiler/*.h')
  while read -r number name; do
    grep -qsE "^(error|warning|note)\[$number\]" tests/golden/*/expected/transcript.txt && continue
    ((${#list[@]} > 0)) &&
      grep -qE "Code::$name\>|^TEST(_F)?\([A-Za-z]*Code, $name\)" -- "${list[@]}" && continue
    breach "compiler/diagnostics: no test provokes $number, $name"
  done < <(cat compiler/diagnostics/codes_*.def | tr '\n' ' ' |
    grep -oE 'RTAC_DIAGNOSTIC\( *[0-9]+, *[a-z0-9_]+' | sed 's/.*( *//; s/, */ /')
}

# Every report that a golden case shows says what would work.
check_helps() {
  local without list
  mapfile -t list < <(files 'tests/golden/*/expected/transcript.txt')
  without=$(awk '
    function leave() { if (head != "" && !helped) print head; head = "" }
    FNR == 1 || /^$/ || /^\$ rtac/ { leave() }
    /^(error|warning|note)\[[0-9]+\]/ { leave(); head = FILENAME ": " $0; helped = 0 }
    /^help: ./ { helped = 1 }
    END { leave() }' /dev/null ${list[@]+"${list[@]}"})
  if [[ -n $without ]]; then
    breach "$without: no help says what would work"
  fi
}

# Every numbered rule of the language has a test of its name, and no test the name of a rule that is
# not there: `### Rule 2.1 once` is tested by TEST(Rule2_1, ...). Tests of whole chapters, `Rule9`,
# count for none of their rules.
check_rules() {
  local page=compiler/docs/language.md rule name list rules
  mapfile -t list < <(files 'tests/*.cpp')
  rules=$(sed -n 's/^### Rule \([0-9.]*\) .*/\1/p' $page)
  [[ -n $rules ]] || breach "$page: no rules were found"
  while IFS= read -r rule; do
    ((${#list[@]} > 0)) && grep -qE "^TEST(_F|_P)?\(Rule${rule//./_}," -- "${list[@]}" && continue
    breach "$page: no test is called Rule${rule//./_}"
  done <<<"$rules"
  while IFS= read -r name; do
    rule=${name//_/.}
    grep -qE "^##+ Rule ${rule//./\\.}[: ]" $page || breach "tests: Rule$name is no rule of $page"
  done < <(grep -ohE '^TEST(_F|_P)?\(Rule[0-9_]+,' -- /dev/null ${list[@]+"${list[@]}"} |
    sed -E 's/.*\(Rule([0-9_]+),/\1/' | LC_ALL=C sort -u)
}

# The build gives its number to generated code; the runtime states the one that it serves.
check_abi() {
  local build runtime header=runtime/include/rtac/kernel_bridge.h
  build=$(sed -n 's/^set(RTAC_ABI \([0-9]*\))$/\1/p' CMakeLists.txt)
  runtime=$(sed -n 's/^inline constexpr int abi = \([0-9]*\);$/\1/p' $header)
  [[ -n $build && $build == "$runtime" ]] ||
    breach "$header: abi is \`$runtime\`, RTAC_ABI in CMakeLists.txt is \`$build\`"
}

# What `./dev campaign` has found, as it was committed: every template with its motion once, and
# nothing else.
check_campaign() {
  local summary=tests/campaign/summary.txt spec name row='[^ ]+ +1-100000 +0  [0-9a-f]{16}'
  grep -vnE "^(template +seeds +violations +hash|$row)\$" "$summary" &&
    breach "$summary: these lines are not of a whole summary without violations"
  while IFS= read -r spec; do
    name=$(basename -- "$spec" .rta)
    [[ $(grep -c "^$name " "$summary") == 1 ]] || breach "$summary: $name is not in it once"
  done < <(files 'tests/campaign/specs/templates/*_*.rta')
}

"check_$check"
((breaches == 0))
