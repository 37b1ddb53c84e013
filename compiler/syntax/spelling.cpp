#include "compiler/syntax/spelling.h"

namespace rtac::syntax {

std::string_view spell(BinaryOp op) {
  switch (op) {
    case BinaryOp::iff:
      return "iff";
    case BinaryOp::implies:
      return "implies";
    case BinaryOp::logical_xor:
      return "xor";
    case BinaryOp::logical_or:
      return "or";
    case BinaryOp::logical_and:
      return "and";
    case BinaryOp::less:
      return "<";
    case BinaryOp::less_equal:
      return "<=";
    case BinaryOp::greater:
      return ">";
    case BinaryOp::greater_equal:
      return ">=";
    case BinaryOp::equal:
      return "==";
    case BinaryOp::not_equal:
      return "!=";
    case BinaryOp::inside:
      return "inside";
    case BinaryOp::zone_union:
      return "|";
    case BinaryOp::zone_intersection:
      return "&";
    case BinaryOp::add:
      return "+";
    case BinaryOp::subtract:
      return "-";
    case BinaryOp::multiply:
      return "*";
    case BinaryOp::divide:
      return "/";
  }
  return {};
}

std::string_view spell(UnaryOp op) {
  switch (op) {
    case UnaryOp::negate:
      return "-";
    case UnaryOp::logical_not:
      return "not";
  }
  return {};
}

std::string_view spell(PastOp op) {
  switch (op) {
    case PastOp::once:
      return "once";
    case PastOp::historically:
      return "historically";
  }
  return {};
}

std::string_view spell(ImportWord word) {
  switch (word) {
    case ImportWord::feature:
      return "feature";
    case ImportWord::unit:
      return "in";
    case ImportWord::axes:
      return "axes";
    case ImportWord::inclusions:
      return "inclusions";
    case ImportWord::exclusions:
      return "exclusions";
    case ImportWord::flat:
      return "flat";
    case ImportWord::timeless:
      return "timeless";
    case ImportWord::heights:
      return "heights";
    case ImportWord::scheduled:
      return "scheduled";
  }
  return {};
}

std::string_view spell(Quantifier quantifier) {
  switch (quantifier) {
    case Quantifier::forall:
      return "forall";
    case Quantifier::exists:
      return "exists";
  }
  return {};
}

std::string_view spell(Relation relation) {
  switch (relation) {
    case Relation::at_most:
      return "<=";
    case Relation::at_least:
      return ">=";
  }
  return {};
}

std::string_view spell(Role role) {
  switch (role) {
    case Role::advanced:
      return "advanced";
    case Role::safe:
      return "safe";
  }
  return {};
}

std::string spell_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        result += "\\\"";
        break;
      case '\\':
        result += "\\\\";
        break;
      case '\n':
        result += "\\n";
        break;
      case '\t':
        result += "\\t";
        break;
      default:
        result += c;
    }
  }
  return result + '"';
}

std::string join(const std::vector<Name>& names, std::string_view separator) {
  std::string result;
  for (const Name& name : names) {
    if (!result.empty()) result += separator;
    result += name.text;
  }
  return result;
}

}  // namespace rtac::syntax
