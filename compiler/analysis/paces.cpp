#include "compiler/analysis/paces.h"

#include <optional>
#include <variant>

#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

class Paces {
 public:
  Paces(const ir::Block& block, std::int64_t mmps, std::int64_t from_rest_mmps,
        const KeepsElsewhere& keeps_elsewhere)
      : block_(block),
        mmps_(mmps),
        from_rest_mmps_(from_rest_mmps),
        keeps_elsewhere_(keeps_elsewhere) {}

  [[nodiscard]] Pace of(ir::ValueId id) const {
    const ir::Op& op = block_[id].op;
    if (told(block_, id)) return Pace::told;
    if (const auto* v = std::get_if<ir::And>(&op)) return both(of(v->a), of(v->b));
    if (const auto* v = std::get_if<ir::Or>(&op)) return either(*v);
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (compare == nullptr) return Pace::broken;
    const auto most = most_mmps(*compare);
    const bool kept = most ? mmps_ <= *most : keeps_elsewhere_(block_, *compare);
    return kept ? Pace::kept : Pace::broken;
  }

 private:
  static Pace both(Pace a, Pace b) {
    for (const Pace worst : {Pace::broken, Pace::while_told}) {
      if (a == worst || b == worst) return worst;
    }
    return a == b ? a : Pace::told_kept;
  }
  [[nodiscard]] Pace either(const ir::Or& v) const {
    const Pace a = of(v.a), b = of(v.b);
    if (a == Pace::kept || b == Pace::kept) return Pace::kept;
    if (a == Pace::broken && b == Pace::broken) return Pace::broken;
    // where the side that is broken lets a robot at rest go on, it would do so and stop for ever
    if (a == Pace::broken) return waits(v.a) ? Pace::while_told : Pace::broken;
    if (b == Pace::broken) return waits(v.b) ? Pace::while_told : Pace::broken;
    return a == Pace::while_told || b == Pace::while_told ? Pace::while_told : Pace::told_kept;
  }
  // A limit of speed that a robot at rest might exceed, and nothing instead of it.
  [[nodiscard]] bool waits(ir::ValueId id) const {
    const ir::Op& op = block_[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return waits(v->a) || waits(v->b);
    if (const auto* v = std::get_if<ir::Or>(&op)) return waits(v->a) && waits(v->b);
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    const auto most = compare ? most_mmps(*compare) : std::nullopt;
    return most && from_rest_mmps_ > *most;
  }
  [[nodiscard]] std::optional<std::int64_t> most_mmps(const ir::AtLeast& compare) const {
    const auto bound = ir::upper_bound(block_, compare);
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::speed) return std::nullopt;
    return bound->most;
  }

  const ir::Block& block_;
  const std::int64_t mmps_, from_rest_mmps_;
  const KeepsElsewhere& keeps_elsewhere_;
};

}  // namespace

Pace pace_of(const ir::Block& block, ir::ValueId id, std::int64_t mmps, std::int64_t from_rest_mmps,
             const KeepsElsewhere& keeps_elsewhere) {
  return Paces(block, mmps, from_rest_mmps, keeps_elsewhere).of(id);
}

bool told(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::Not>(&op)) return told(block, v->a);
  if (const auto* v = std::get_if<ir::And>(&op)) return told(block, v->a) && told(block, v->b);
  if (const auto* v = std::get_if<ir::Or>(&op)) return told(block, v->a) && told(block, v->b);
  return std::holds_alternative<ir::Fact>(op);
}

}  // namespace rtac::analysis
