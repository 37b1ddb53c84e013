#include "compiler/analysis/zone_text.h"

#include <variant>

#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

std::string of_zone(const sema::Spec& spec, sema::ZoneId zone) {
  const sema::Zone& of = spec[zone];
  return of.name.empty() ? zone_text(spec, *of.value) : of.name;
}
const sema::ZoneExpr& behind_names(const sema::Spec& spec, const sema::ZoneExpr& zone) {
  const auto* ref = std::get_if<sema::ZoneRef>(&zone.node);
  const bool unnamed = ref != nullptr && spec[ref->zone].name.empty();
  return unnamed ? behind_names(spec, *spec[ref->zone].value) : zone;
}
std::string operand(const sema::Spec& spec, const sema::ZoneExpr& zone) {
  const std::string text = zone_text(spec, zone);
  const bool binary = std::holds_alternative<sema::ZoneBinary>(behind_names(spec, zone).node);
  return binary && !text.empty() ? "(" + text + ")" : text;
}
const char* sign(sema::ZoneOp op) {
  if (op == sema::ZoneOp::unite) return " | ";
  return op == sema::ZoneOp::intersect ? " & " : " - ";
}

}  // namespace

std::string zone_text(const sema::Spec& spec, const sema::ZoneExpr& zone) {
  if (const auto* ref = std::get_if<sema::ZoneRef>(&zone.node)) return of_zone(spec, ref->zone);
  if (const auto* of = std::get_if<sema::ZoneComplement>(&zone.node)) {
    const std::string text = of_zone(spec, of->zone);
    return text.empty() ? "" : "complement(" + text + ")";
  }
  if (const auto* both = std::get_if<sema::ZoneBinary>(&zone.node)) {
    // `a & b & c` is read from the left
    const auto* first = std::get_if<sema::ZoneBinary>(&behind_names(spec, *both->left).node);
    const bool same = first != nullptr && first->op == both->op;
    const std::string left = same ? zone_text(spec, *both->left) : operand(spec, *both->left),
                      right = operand(spec, *both->right);
    return left.empty() || right.empty() ? "" : left + sign(both->op) + right;
  }
  if (const auto* by = std::get_if<sema::ZoneOffset>(&zone.node)) {
    const std::string of = zone_text(spec, *by->operand);
    const Rational far = by->distance < 0 ? Rational(-by->distance) : by->distance;
    if (of.empty()) return "";
    return (by->distance < 0 ? "shrink(" : "grow(") + of + ", " + metres(far) + ")";
  }
  return "";
}

}  // namespace rtac::analysis
