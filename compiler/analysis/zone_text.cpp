#include "compiler/analysis/zone_text.h"

#include <algorithm>
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

// With sides along the axes, from its lower left corner, on the millimetre; "": it is none.
std::string rectangle_text(const sema::ZonePolygon& polygon) {
  const auto& p = polygon.outer.points;
  if (p.size() != 4 || !polygon.holes.empty()) return "";
  const bool along = p[0].y == p[1].y && p[1].x == p[2].x && p[2].y == p[3].y && p[3].x == p[0].x;
  const bool fine = std::ranges::any_of(p, [](const sema::Point& at) {
    return Rational(at.x * 1000).get_den() != 1 || Rational(at.y * 1000).get_den() != 1;
  });
  if (!along || fine || p[0].x >= p[2].x || p[0].y >= p[2].y) return "";
  const auto corner = [](const sema::Point& at) {
    return "(" + metres(at.x) + ", " + metres(at.y) + ")";
  };
  return "rectangle " + corner(p[0]) + " to " + corner(p[2]);
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
  if (const auto* prism = std::get_if<sema::ZonePrism>(&zone.node)) {
    const std::string base = zone_text(spec, *prism->base);
    if (base.empty()) return "";
    return "prism (" + base + ") from " + metres(prism->floor) + " to " + metres(prism->ceiling);
  }
  if (const auto* polygon = std::get_if<sema::ZonePolygon>(&zone.node)) {
    return rectangle_text(*polygon);
  }
  return "";
}

}  // namespace rtac::analysis
