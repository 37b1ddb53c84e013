#include "compiler/verify/at_worst.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"

namespace rtac::verify {
namespace {

class Terms {
 public:
  Terms(const ir::Decision& decision, const ir::Block& property)
      : decision_(decision), property_(property) {}

  std::optional<std::vector<Term>> all() {
    if (!collect(property_.result)) return std::nullopt;
    return std::move(found_);
  }

 private:
  bool collect(ir::ValueId id) {
    if (!analysis::speaks_of_windows(property_, id)) return true;
    if (const auto* both = std::get_if<ir::And>(&property_[id].op)) {
      return collect(both->a) && collect(both->b);
    }
    const auto term = term_of(id);
    if (term) found_.push_back(*term);
    return term.has_value();
  }
  void flatten(ir::ValueId id, std::vector<ir::ValueId>& sides) const {
    const auto* either = std::get_if<ir::Or>(&property_[id].op);
    if (either == nullptr) return sides.push_back(id);
    flatten(either->a, sides);
    flatten(either->b, sides);
  }
  [[nodiscard]] bool is_there(ir::ValueId id) const {
    return std::holds_alternative<ir::ZoneThere>(property_[id].op);
  }
  [[nodiscard]] std::optional<Limit> limit_of(ir::ValueId id) const {
    const auto* compare = std::get_if<ir::AtLeast>(&property_[id].op);
    const auto bound =
        compare ? ir::lower_bound(property_, *compare, decision_.facts.params) : std::nullopt;
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) return std::nullopt;
    return Limit{ir::ZoneIndex{bound->leaf.table},
                 std::max<std::int64_t>(bound->need.strictest, 0)};
  }
  // While a zone is there, to be in it.
  [[nodiscard]] std::optional<Limit> gated(ir::ValueId id) const {
    const auto* both = std::get_if<ir::And>(&property_[id].op);
    if (both == nullptr) return std::nullopt;
    if (is_there(both->a)) return limit_of(both->b);
    return is_there(both->b) ? limit_of(both->a) : std::nullopt;
  }
  // One limit, but for while a zone is gone; or one zone to be in, or others while they are there.
  [[nodiscard]] std::optional<Term> term_of(ir::ValueId id) const {
    std::vector<ir::ValueId> sides;
    flatten(id, sides);
    std::vector<Limit> always, at_times;
    bool goes = false;
    for (const ir::ValueId side : sides) {
      const auto* no = std::get_if<ir::Not>(&property_[side].op);
      if (no != nullptr && is_there(no->a)) {
        goes = true;
      } else if (const auto limit = limit_of(side)) {
        always.push_back(*limit);
      } else if (const auto gate = gated(side)) {
        at_times.push_back(*gate);
      } else {
        return std::nullopt;
      }
    }
    if (always.size() != 1 || (goes && !at_times.empty())) return std::nullopt;
    Term term{always.front(), {}};
    if (at_times.empty()) return term;
    at_times.push_back(term.kept);
    for (const Limit& each : at_times) {
      if (each.mm > 0) return std::nullopt;
      term.either.push_back(each.zone);
    }
    return term;
  }

  const ir::Decision& decision_;
  const ir::Block& property_;
  std::vector<Term> found_;
};

}  // namespace

std::optional<std::vector<Term>> at_worst(const ir::Decision& decision, const ir::Block& property) {
  return Terms(decision, property).all();
}

}  // namespace rtac::verify
