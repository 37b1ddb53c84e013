# Input: first the rules (include_rules.txt), then C and C++ sources. Prints every include that its
# folder may not have; exit code 1 when there is one.
#
# "A/." as a permission means the files of folder A, not those of its subfolders.

function folder_of(path) {
  sub(/\/[^\/]*$/, "", path)
  return path
}

# The folder or library that an include line is about; "" for the standard library, system headers
# and files next to the one that includes them.
function target_of(line, name, quoted) {
  quoted = line ~ /"/
  name = line
  sub(/^[^"<]*["<]/, "", name)
  sub(/[">].*$/, "", name)
  if (name ~ /^rtac\//) return folder_of("runtime/include/" name)
  if (name ~ /(^|\/)\.\.\//) return "a path with .."
  if (name ~ /^(compiler|runtime|examples|tests)\//) return folder_of(name)
  if (name ~ /^CGAL\//) return "CGAL"
  if (name ~ /^ompl\//) return "OMPL"
  if (name ~ /^(coin\/)?Ip[A-Z][A-Za-z]*\.hpp$/) return "Ipopt"
  if (name ~ /^(unsupported\/)?Eigen\//) return "Eigen"
  if (name ~ /^nlohmann\//) return "json"
  if (name ~ /^pugixml/) return "pugixml"
  if (name ~ /^gmp/) return "gmp"
  if (name ~ /^GeographicLib\//) return "GeographicLib"
  return ""
}

function rule_for(folder) {
  while (folder != "") {
    if (folder in allowed) return folder
    if (folder !~ /\//) return ""
    folder = folder_of(folder)
  }
  return ""
}

function permits(folder, target, count, parts, i) {
  count = split(allowed[folder], parts, " ")
  for (i = 1; i <= count; i++) {
    if (target == parts[i] || target "/." == parts[i]) return 1
    if (parts[i] !~ /\/\.$/ && index(target, parts[i] "/") == 1) return 1
  }
  return 0
}

function complain(text) {
  printf "%s:%d: %s\n", FILENAME, FNR, text
  failed = 1
}

NR == FNR {
  if ($0 !~ /^(#|[ \t]*$)/) {
    key = $1
    $1 = ""
    allowed[key] = $0
  }
  next
}

FNR == 1 {
  folder = folder_of(FILENAME)
  rule = rule_for(folder)
  if (rule == "") complain("no line in tests/repo/include_rules.txt for " folder)
}

rule != "" && /^[ \t]*#[ \t]*include[ \t]*["<]/ {
  target = target_of($0)
  if (target != "" && !permits(rule, target)) complain(rule " may not include " target ": " $0)
}

END { exit failed }
