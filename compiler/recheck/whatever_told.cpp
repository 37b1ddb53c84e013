#include "compiler/recheck/whatever_told.h"

#include <algorithm>
#include <map>
#include <string>
#include <variant>

#include "compiler/sema/spec_printer.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

constexpr std::size_t conditions_most = 10;
using Told = std::map<std::string, bool>;  // by the text of the condition

bool is_condition(const sema::Spec& spec, const sema::Expr& e) {
  return !sema::speaks_of_robot(e) && !spoken_of(spec, e).empty();
}

void find_conditions(const sema::Spec& spec, const sema::Expr& e, Told& all) {
  if (const auto* const logic = std::get_if<sema::Logic>(&e.node)) {
    for (const sema::ExprPtr& each : logic->operands) find_conditions(spec, *each, all);
  } else if (is_condition(spec, e)) {
    all.emplace(sema::dump(spec, e), false);
  }
}

class Truths {
 public:
  Truths(const sema::Spec& spec, const Told& told, const MayBe& may_be)
      : spec_(spec), told_(told), may_be_(may_be) {}

  [[nodiscard]] bool can_be(const sema::Expr& e, bool value) const {
    if (const auto* const truth = std::get_if<sema::Truth>(&e.node)) return truth->value == value;
    if (const auto* const logic = std::get_if<sema::Logic>(&e.node))
      return connected(*logic, value);
    if (is_condition(spec_, e)) return told_.at(sema::dump(spec_, e)) == value;
    return !spoken_of(spec_, e).empty() || may_be_(e, value);
  }

 private:
  [[nodiscard]] bool connected(const sema::Logic& v, bool value) const {
    const auto some = [&](bool of) {
      return std::ranges::any_of(v.operands, [&](const auto& each) { return can_be(*each, of); });
    };
    const auto all = [&](bool of) {
      return std::ranges::all_of(v.operands, [&](const auto& each) { return can_be(*each, of); });
    };
    switch (v.op) {
      case sema::LogicOp::logical_not:
        return can_be(*v.operands[0], !value);
      case sema::LogicOp::logical_and:
        return value ? all(true) : some(false);
      case sema::LogicOp::logical_or:
        return value ? some(true) : all(false);
      case sema::LogicOp::implies:
        return value ? can_be(*v.operands[0], false) || can_be(*v.operands[1], true)
                     : can_be(*v.operands[0], true) && can_be(*v.operands[1], false);
      case sema::LogicOp::iff:
      case sema::LogicOp::logical_xor:
        break;  // anything
    }
    return true;
  }

  const sema::Spec& spec_;
  const Told& told_;
  const MayBe& may_be_;
};

}  // namespace

bool true_whatever_told(const sema::Spec& spec, const sema::Expr& property, const MayBe& may_be) {
  Told told;
  find_conditions(spec, property, told);
  if (told.size() > conditions_most) return false;
  for (std::size_t set = 0; set < std::size_t{1} << told.size(); ++set) {
    std::size_t k = 0;
    for (auto& [condition, is_so] : told) is_so = (set >> k++ & 1U) != 0;
    if (Truths(spec, told, may_be).can_be(property, false)) return false;
  }
  return true;
}

}  // namespace rtac::recheck
