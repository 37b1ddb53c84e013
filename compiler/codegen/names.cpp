#include "compiler/codegen/names.h"

#include <cctype>

namespace rtac::codegen {
namespace {

const std::set<std::string>& reserved() {
  static const std::set<std::string> words = {
      "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break",
      "case", "catch", "char", "char16_t", "char32_t", "class", "compl", "const", "const_cast",
      "constexpr", "continue", "decltype", "default", "delete", "do", "double", "dynamic_cast",
      "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto",
      "if", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq",
      "nullptr", "operator", "or", "or_eq", "private", "protected", "public", "register",
      "reinterpret_cast", "restrict", "return", "short", "signed", "sizeof", "static",
      "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local",
      "throw", "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using",
      "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq", "concept", "requires",
      "co_await", "co_return", "co_yield", "consteval", "constinit", "char8_t", "import", "module",
      // names of libraries, and macros of common headers
      "std", "rtac", "main", "errno", "assert", "NULL", "EOF", "stdin", "stdout", "stderr", "linux",
      "unix", "major", "minor", "signbit", "isnan", "isinf"};
  return words;
}

}  // namespace

std::string legal(const std::string& name) {
  return reserved().count(name) > 0 ? name + "_" : name;
}

std::string camel(const std::string& name) {
  std::string out;
  bool start = true;
  for (const char c : name) {
    if (c == '_') {
      start = true;
      continue;
    }
    out += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    start = false;
  }
  if (out.empty() || std::isdigit(static_cast<unsigned char>(out[0]))) out.insert(0, "_");
  return legal(out);
}

std::string upper(const std::string& name) {
  std::string out;
  for (const char c : name) {
    out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

std::string NameScope::claim(const std::string& name) {
  std::string candidate = legal(name);
  while (!taken_.insert(candidate).second) candidate += "_";
  return candidate;
}

}  // namespace rtac::codegen
