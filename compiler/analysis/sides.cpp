#include "compiler/analysis/sides.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/printer.h"

namespace rtac::analysis {
namespace {

bool collect_sides(const ir::Module& module, const ir::Decision& decision, const ir::Block& block,
                   ir::ValueId id, std::vector<ir::ZoneIndex>& zones) {
  if (const auto* v = std::get_if<ir::Or>(&block[id].op)) {
    return collect_sides(module, decision, block, v->a, zones) &&
           collect_sides(module, decision, block, v->b, zones);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&block[id].op);
  const auto bound =
      compare ? ir::lower_bound(block, *compare, decision.facts.params) : std::nullopt;
  if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance || bound->need.strictest != 0 ||
      compare->strict || !bound->need.params.empty()) {
    return false;
  }
  const ir::ZoneIndex zone{bound->leaf.table};
  if (module[zone].has_height()) return false;
  zones.push_back(zone);
  return true;
}

}  // namespace

Rational metres_of(std::int64_t mm) {
  Rational m(static_cast<long>(mm), 1000);
  m.canonicalize();
  return m;
}

namespace {

// What a value comes to of a robot that is slow, as far as that and inputs tell.
class OfSlow {
 public:
  OfSlow(const ir::Module& module, const ir::Watch& facts, const ir::Block& block,
         std::int64_t mmps)
      : module_(module), facts_(facts), block_(block), mmps_(mmps) {}

  // Whatever the inputs say.
  bool holds(ir::ValueId id) {
    ask(id);
    constexpr std::size_t most = 6;  // of which each may be true or false
    if (asked_.size() > most) return false;
    for (std::uint32_t told = 0; told >> asked_.size() == 0; ++told) {
      if (!holds(id, told)) return false;
    }
    return true;
  }

 private:
  void ask(ir::ValueId id) {
    const ir::Op& op = block_[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return ask(v->a), ask(v->b);
    if (const auto* v = std::get_if<ir::Or>(&op)) return ask(v->a), ask(v->b);
    if (const auto* v = std::get_if<ir::Not>(&op)) return ask(v->a);
    const auto* fact = std::get_if<ir::Fact>(&op);
    if (fact == nullptr || says_.count(fact->index) != 0) return;
    Said said = said_by(*fact);
    const auto found = std::ranges::find(asked_, said.text);
    says_[fact->index] = {static_cast<std::size_t>(found - asked_.begin()), said.value};
    if (found == asked_.end()) asked_.push_back(std::move(said.text));
  }
  // Facts are as many as there are mentions of them, each with its negation. Equal texts are equal
  // values (passes: share_values).
  struct Said {
    std::string text;
    bool value = true;
  };
  [[nodiscard]] Said said_by(const ir::Fact& fact) const {
    const ir::Block& property = facts_.monitors[fact.index].property;
    const ir::Op& op = property[property.result].op;
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    const bool negated = std::holds_alternative<ir::Not>(op);
    std::string text = ir::print(module_, &facts_, property, "");
    // its last line names the result, which is that of the line above
    for (int lines = negated || compare != nullptr ? 2 : 1; lines > 0; --lines) {
      text.erase(text.rfind('\n', text.size() - 2) + 1);
    }
    if (compare == nullptr) return {std::move(text), !negated};
    // a > b is what b >= a denies
    const auto [a, b] =
        compare->strict ? std::pair(compare->b, compare->a) : std::pair(compare->a, compare->b);
    text += std::to_string(static_cast<std::uint32_t>(a)) +
            " >= " + std::to_string(static_cast<std::uint32_t>(b));
    return {std::move(text), !compare->strict};
  }
  // `told`: a bit of each.
  [[nodiscard]] bool holds(ir::ValueId id, std::uint32_t told) const {
    const ir::Op& op = block_[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return holds(v->a, told) && holds(v->b, told);
    if (const auto* v = std::get_if<ir::Or>(&op)) return holds(v->a, told) || holds(v->b, told);
    if (const auto* v = std::get_if<ir::Not>(&op)) {
      const bool is_told = std::holds_alternative<ir::Fact>(block_[v->a].op);
      return is_told && !holds(v->a, told);
    }
    if (const auto* fact = std::get_if<ir::Fact>(&op)) {
      const auto& [place, value] = says_.at(fact->index);
      return ((told >> place & 1U) != 0) == value;
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    const auto bound = compare ? ir::upper_bound(block_, *compare) : std::nullopt;
    return bound && bound->leaf.kind == ir::Leaf::Kind::speed && mmps_ <= bound->most;
  }

  const ir::Module& module_;
  const ir::Watch& facts_;
  const ir::Block& block_;
  const std::int64_t mmps_;
  std::vector<std::string> asked_;
  std::map<std::uint32_t, std::pair<std::size_t, bool>> says_;  // by fact: which of them, or not
};

}  // namespace

bool asks_for_slow(const ir::Module& module, const ir::Decision& decision, const ir::Block& block,
                   ir::ValueId id, std::int64_t mmps) {
  return OfSlow(module, decision.facts, block, mmps).holds(id);
}

bool has_slow_side(const ir::Module& module, const ir::Decision& decision, std::size_t k,
                   const ir::Block& block, const ir::Or& either) {
  // what an external one claims of its speed is held against its measured speed alone
  if (decision.monitors[k].recovery.claims) return false;
  const std::int64_t mmps = fastest_while_driving(decision, k);
  return asks_for_slow(module, decision, block, either.a, mmps) ||
         asks_for_slow(module, decision, block, either.b, mmps);
}

namespace {

// Whether it speaks of a kind of signals.
bool speaks_of(const ir::Block& block, ir::ValueId id, ir::Leaf::Kind kind) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return speaks_of(block, v->a, kind) || speaks_of(block, v->b, kind);
  }
  if (const auto* v = std::get_if<ir::Or>(&op)) {
    return speaks_of(block, v->a, kind) || speaks_of(block, v->b, kind);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return false;
  const auto terms = ir::linear_form(block, *compare).terms;
  return std::ranges::any_of(terms, [&](const auto& term) { return term.first.kind == kind; });
}

}  // namespace

bool sets_out_faster(const ir::Module& module, const ir::Decision& decision, std::size_t k,
                     const ir::Block& block, ir::ValueId id) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    return sets_out_faster(module, decision, k, block, v->a) ||
           sets_out_faster(module, decision, k, block, v->b);
  }
  const auto* either = std::get_if<ir::Or>(&block[id].op);
  if (either == nullptr || !speaks_of(block, id, ir::Leaf::Kind::clearance) ||
      !speaks_of(block, id, ir::Leaf::Kind::speed)) {
    return false;
  }
  return !has_slow_side(module, decision, k, block, *either) &&
         !asks_for_slow(module, decision, block, id, fastest_while_driving(decision, k));
}

std::vector<ir::ZoneIndex> sides_in_zones(const ir::Module& module, const ir::Decision& decision,
                                          const ir::Block& block, ir::ValueId id) {
  std::vector<ir::ZoneIndex> zones;
  if (!collect_sides(module, decision, block, id, zones)) zones.clear();
  return zones;
}

// A disc in `own` that lies in none of the zones alone meets, for each of them, what they leave out
// of `own`.
std::optional<geometry::Region> between(const geometry::Region& own,
                                        const std::vector<ir::ZoneIndex>& zones,
                                        const ExactZone& exact, std::int64_t own_mm,
                                        std::int64_t side_mm) {
  auto left = within(own, own_mm);
  for (const ir::ZoneIndex zone : zones) {
    if (!left || left->empty()) return left;
    const auto meets =
        own.subtract(exact(zone)).offset(metres_of(std::max<std::int64_t>(side_mm, 0)));
    if (!meets) return std::nullopt;
    left = left->intersect(*meets);
  }
  return left;
}

std::optional<geometry::Region> places_of_discs(const std::vector<ir::ZoneIndex>& zones,
                                                const ExactZone& exact, std::int64_t radius_mm) {
  geometry::Region places;
  for (const ir::ZoneIndex zone : zones) {
    const auto in_it = within(exact(zone), radius_mm);
    if (!in_it) return std::nullopt;
    places = places.unite(*in_it);
  }
  return places;
}

bool straight_between(const std::vector<ir::ZoneIndex>& zones, const ExactZone& exact,
                      std::int64_t radius_mm) {
  const auto places = places_of_discs(zones, exact, radius_mm);
  return places && is_convex(*places);
}

bool keeps_a_side(const ir::Module& module, const ir::Decision& decision, const ExactZone& exact,
                  std::size_t k, const ir::Block& block, ir::ValueId id) {
  const auto& either = std::get<ir::Or>(block[id].op);
  if (has_slow_side(module, decision, k, block, either)) return true;
  const auto zones = sides_in_zones(module, decision, block, id);
  if (zones.empty()) return false;
  const auto steps = ir::steps_of(decision.monitors[k].recovery);
  return std::all_of(steps.begin(), steps.end(), [&](const ir::Recovery* step) {
    if (!ir::moves(step->kind) && !step->claims) return true;  // it stays where a side held
    if (module[step->zone].has_height()) return false;
    const geometry::Region& own = exact(step->zone);
    geometry::Region all;
    for (const ir::ZoneIndex zone : zones) all = all.unite(exact(zone));
    if (!all.contains(own)) return false;
    const std::int64_t radius_mm = decision.body.radius_mm;
    // through a neck that is hardly too narrow ways lead as well, by what they lose
    const std::int64_t own_mm = std::max<std::int64_t>(0, radius_mm - ways_lose_mm);
    const auto none =
        between(own, zones, exact, own_mm - offsets_round_mm, radius_mm + offsets_round_mm);
    return none && none->empty();
  });
}

}  // namespace rtac::analysis
