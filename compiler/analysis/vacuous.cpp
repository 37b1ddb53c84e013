#include "compiler/analysis/vacuous.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/analysis/boundless.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/printer.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using ir::Leaf;

// Beyond any signal of a robot, in steps of its grid.
constexpr std::int64_t far_away = std::int64_t{1} << 48;
constexpr std::int64_t full_ppm = 1'000'000;

// What a signal can be at all, and what it is sure to be somewhere, in steps of its grid.
struct Extent {
  std::int64_t lo = -far_away, hi = far_away;
  std::int64_t lo_shown = -far_away, hi_shown = far_away;
};
Extent exactly(std::int64_t lo, std::int64_t hi) {
  return {lo, hi, lo, hi};
}

// Of a zone from its table. What has no end there reaches as far as coordinates do.
struct Shape {
  bool bounded = true;
  std::int64_t depth_mm =
      0;  // outside, nothing is farther from its boundary, where it is unbounded
};
Shape shape_of(const ir::ZoneTable& zone) {
  Shape shape;
  std::int64_t low_x = far_away, low_y = far_away, high_x = -far_away, high_y = -far_away;
  for (const ir::Edge& e : zone.edges) {
    if (is_at_the_end(e)) {
      shape.bounded = false;
      continue;
    }
    low_x = std::min<std::int64_t>({low_x, e.ax, e.bx});
    high_x = std::max<std::int64_t>({high_x, e.ax, e.bx});
    low_y = std::min<std::int64_t>({low_y, e.ay, e.by});
    high_y = std::max<std::int64_t>({high_y, e.ay, e.by});
  }
  if (!shape.bounded) {
    shape.depth_mm = std::max<std::int64_t>(0, std::min(high_x - low_x, high_y - low_y) / 2 + 1);
  }
  return shape;
}

// A state of the world in which a formula has the value that is asked for, as far as each signal by
// itself tells: which way each of them goes, and what is told from outside.
using Ways = std::map<std::pair<const ir::Block*, Leaf>, int>;
struct State {
  CanFail can = CanFail::yes;
  Ways ways{};
  std::map<std::string, bool> told{};
};
// One of them; of more than so many the rest is open. None: there is no such state.
using Any = std::vector<State>;
constexpr std::size_t states_most = 64;

// What is told as a truth is told by itself; whatever else two facts say may exclude each other.
const char* const by_itself = "truth ";

class Finder {
 public:
  Finder(const ir::Module& module, const ir::Decision& decision, CanBeTold told)
      : module_(module), decision_(decision), told_(told) {}

  const Any& find(const ir::Block& block, ir::ValueId id, bool value) {
    const auto known = found_.find({&block, id, value});
    if (known != found_.end()) return known->second;
    return found_.emplace(std::tuple(&block, id, value), search(block, id, value)).first->second;
  }

  [[nodiscard]] std::string text_of(const Leaf& leaf, int way) const {
    const std::string zone = leaf.kind == Leaf::Kind::clearance
                                 ? module_[ir::ZoneIndex{leaf.table}].name
                             : leaf.kind == Leaf::Kind::received ? received(leaf).name
                                                                 : "";
    switch (leaf.kind) {
      case Leaf::Kind::battery:
        return way < 0 ? "with an empty battery" : "with a full battery";
      case Leaf::Kind::clearance:
        return (way < 0 ? "outside of `" : "in the middle of `") + zone + "`";
      case Leaf::Kind::distance:
        return way < 0 ? "where two robots are in the same place" : "where robots are far apart";
      case Leaf::Kind::energy_to:
        return way < 0 ? "at the site" : "far from the site";
      case Leaf::Kind::count:
        return way < 0 ? "where no other robot satisfies it" : "where all others satisfy it";
      case Leaf::Kind::speed:
        return way < 0 ? "at rest" : "at full speed";
      case Leaf::Kind::altitude:
        return way < 0 ? "far below" : "far above";
      case Leaf::Kind::agent:
        return way < 0 ? "where an agent touches the robot" : "far from agents";
      case Leaf::Kind::received:
        return (way < 0) != received(leaf).outside ? "outside of `" + zone + "`"
                                                   : "inside `" + zone + "`";
    }
    std::abort();
  }
  [[nodiscard]] Extent extent_of(const Leaf& leaf) const {
    const std::int64_t radius_mm = decision_.body.radius_mm;
    switch (leaf.kind) {
      case Leaf::Kind::battery:
        return exactly(0, full_ppm);
      case Leaf::Kind::clearance:
        return clearance(module_[ir::ZoneIndex{leaf.table}]);
      case Leaf::Kind::distance:
        return exactly(-2 * radius_mm, far_away);
      case Leaf::Kind::energy_to:
        return {0, far_away, 1, full_ppm};
      case Leaf::Kind::count:
        return exactly(0, std::int64_t{decision_.robots} - 1);
      case Leaf::Kind::speed:
        return exactly(0, decision_.motions.front().speed_mmps);
      case Leaf::Kind::altitude:
        return exactly(-far_away, far_away);
      case Leaf::Kind::agent:
        return exactly(-radius_mm - decision_[ir::AgentIndex{leaf.table}].radius_mm, far_away);
      case Leaf::Kind::received:
        return exactly(-far_away, far_away);
    }
    std::abort();
  }
  // What the signals of the comparisons that are never false can be.
  std::vector<std::string> limits_of(const ir::Block& property) {
    std::vector<std::string> all;
    const auto add = [&](const std::string& text) {
      if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
    };
    ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& v) {
      if (compare(block, v, false).can != no) return;
      for (const auto& [leaf, k] : ir::linear_form(block, v).terms) {
        add(limit_of(leaf, sgn(k) > 0));
      }
    });
    if (is_about_nobody(property)) add("there is no other `" + decision_.kind + "`");
    return all;
  }

  // Of other robots, where there are none.
  [[nodiscard]] bool is_about_nobody(const ir::Block& property) const {
    return decision_.robots < 2 && std::ranges::any_of(property.values, [](const ir::Value& v) {
             return std::holds_alternative<ir::ForOthers>(v.op);
           });
  }

 private:
  // The least or the greatest that a signal can be.
  [[nodiscard]] std::string limit_of(const Leaf& leaf, bool least) const {
    const Extent e = extent_of(leaf);
    const std::int64_t at = least ? e.lo : e.hi;
    const std::string side = least ? "at least " : "at most ";
    switch (leaf.kind) {
      case Leaf::Kind::battery:
      case Leaf::Kind::energy_to:
        return "a charge is " + side + to_decimal(Rational(at, 10'000)) + " %";
      case Leaf::Kind::clearance:
        return "a clearance in `" + module_[ir::ZoneIndex{leaf.table}].name + "` is " + side +
               metres(at);
      case Leaf::Kind::distance:
        return "a distance between bodies is " + side + metres(at);
      case Leaf::Kind::agent:
        return "the distance from `" + decision_[ir::AgentIndex{leaf.table}].name + "` is " + side +
               metres(at);
      case Leaf::Kind::count:
        return "the number of others is " + side + std::to_string(at);
      case Leaf::Kind::speed:
        return "a speed is " + side + metres(at) + "/s";
      case Leaf::Kind::altitude:
        return "a height is " + side + metres(at);
      case Leaf::Kind::received:
        return "a clearance is " + side + metres(at);
    }
    std::abort();
  }
  [[nodiscard]] const ir::Received& received(const Leaf& leaf) const {
    return decision_.facts[ir::ReceivedIndex{leaf.table}];
  }
  static constexpr CanFail yes = CanFail::yes, no = CanFail::no;

  Any search(const ir::Block& block, ir::ValueId id, bool value) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::Truth>(&op)) return v->value == value ? Any{{}} : Any{};
    if (const auto* v = std::get_if<ir::Not>(&op)) return find(block, v->a, !value);
    if (const auto* v = std::get_if<ir::And>(&op)) return pair(block, v->a, v->b, value, value);
    if (const auto* v = std::get_if<ir::Or>(&op)) return pair(block, v->a, v->b, value, !value);
    if (const auto* v = std::get_if<ir::AtLeast>(&op)) {
      State state = compare(block, *v, value);
      return state.can == no ? Any{} : Any{std::move(state)};
    }
    // it takes a while to be true, and is false before
    if (const auto* v = std::get_if<ir::HeldFor>(&op)) {
      return value ? find(block, v->a, true) : Any{{}};
    }
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
      if (decision_.robots < 2) return v->universal == value ? Any{{}} : Any{};
      return find(*v->body, v->body->result, value);
    }
    if (const auto* v = std::get_if<ir::Fact>(&op)) {
      const ir::Block& judged = decision_.facts.monitors[v->index].property;
      return told(judged, judged.result, value);
    }
    // Plans lead anywhere, and zones come and go.
    const bool either =
        std::holds_alternative<ir::PlanInZone>(op) || std::holds_alternative<ir::ZoneThere>(op);
    return {{either ? yes : CanFail::open}};
  }

  // What is told from outside may be either, and is the same wherever it is asked for.
  const Any& told(const ir::Block& block, ir::ValueId id, bool value) {
    const auto known = found_told_.find({&block, id, value});
    if (known != found_told_.end()) return known->second;
    return found_told_.emplace(std::tuple(&block, id, value), search_told(block, id, value))
        .first->second;
  }
  Any search_told(const ir::Block& block, ir::ValueId id, bool value) {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::Truth>(&op)) return v->value == value ? Any{{}} : Any{};
    if (const auto* v = std::get_if<ir::Not>(&op)) return told(block, v->a, !value);
    const auto* both = std::get_if<ir::And>(&op);
    const auto* either = std::get_if<ir::Or>(&op);
    if (both != nullptr || either != nullptr) {
      const ir::ValueId a = both != nullptr ? both->a : either->a;
      const ir::ValueId b = both != nullptr ? both->b : either->b;
      return joined(told(block, a, value), told(block, b, value), (both != nullptr) == value);
    }
    State state;
    if (const auto* v = std::get_if<ir::InputTruth>(&op)) {
      state.told[by_itself + std::to_string(v->channel) + "." + std::to_string(v->component)] =
          value;
    } else {
      state.told[text_up_to(block, id)] = value;
    }
    return {std::move(state)};
  }
  // The same text is the same condition: that of a block up to the value.
  [[nodiscard]] std::string text_up_to(const ir::Block& block, ir::ValueId id) const {
    const ir::Watch* const facts = &decision_.facts;
    const std::string all = ir::print(module_, facts, block, "");
    const std::string next = "%" + std::to_string(static_cast<std::size_t>(id) + 1) + " =";
    return all.substr(0, all.find(next));
  }

  // Both of them, or either.
  Any pair(const ir::Block& block, ir::ValueId a, ir::ValueId b, bool value, bool needs_both) {
    return joined(find(block, a, value), find(block, b, value), needs_both);
  }
  [[nodiscard]] Any joined(Any first, const Any& second, bool needs_both) const {
    if (!needs_both) {
      first.insert(first.end(), second.begin(), second.end());
      return first.size() > states_most ? cut(std::move(first)) : first;
    }
    Any all;
    for (const State& a : first) {
      for (const State& b : second) {
        if (auto state = both_of(a, b)) all.push_back(std::move(*state));
        if (all.size() > states_most) return cut(std::move(all));
      }
    }
    return all;
  }
  static Any cut(Any all) {
    all.resize(states_most);
    all.push_back({CanFail::open});
    return all;
  }
  // nullopt: what is told would have to be two things at once.
  [[nodiscard]] std::optional<State> both_of(State first, const State& second) const {
    for (const auto& [fact, holds] : second.told) {
      const auto [at, is_new] = first.told.try_emplace(fact, holds);
      if (!is_new && at->second != holds) return std::nullopt;
    }
    const bool apart = std::all_of(first.told.begin(), first.told.end(), [](const auto& fact) {
      return fact.first.starts_with(by_itself);
    });
    const bool known = apart || told_ == CanBeTold::yes;
    if (first.told.size() > 1 && !known) first.can = CanFail::open;
    for (const auto& [leaf, way] : second.ways) {
      const auto [at, is_new] = first.ways.try_emplace(leaf, way);
      if (!is_new && at->second != way) first.can = CanFail::open;
    }
    if (second.can == CanFail::open || not_at_once(first.ways)) first.can = CanFail::open;
    return first;
  }
  // Outside of several zones there is a place when they are bounded, which those that are not, or
  // the middles of several ones, need not have.
  [[nodiscard]] bool not_at_once(const Ways& ways) const {
    int outside = 0, particular = 0;
    for (const auto& [of, way] : ways) {
      if (of.second.kind != Leaf::Kind::clearance) continue;
      const bool anywhere_far =
          way < 0 && shape_of(module_[ir::ZoneIndex{of.second.table}]).bounded;
      ++(anywhere_far ? outside : particular);
    }
    return particular > 1 || (particular == 1 && outside > 0);
  }

  State compare(const ir::Block& block, const ir::AtLeast& v, bool value) {
    const ir::Linear form = ir::linear_form(block, v);
    const auto& params = decision_.facts.params;
    Rational most = form.rest.constant, least = most, most_shown = most, least_shown = most;
    for (const auto& [param, k] : form.rest.params) {
      const ir::Range& range = params[param].range;
      const Rational a = k * static_cast<long>(range.lo), b = k * static_cast<long>(range.hi);
      for (Rational* end : {&most, &most_shown}) *end += std::max(a, b);
      for (Rational* end : {&least, &least_shown}) *end += std::min(a, b);
    }
    State state;
    for (const auto& [leaf, k] : form.terms) {
      const Extent e = extent_of(leaf);
      const bool up = sgn(k) > 0;
      most += k * static_cast<long>(up ? e.hi : e.lo);
      least += k * static_cast<long>(up ? e.lo : e.hi);
      most_shown += k * static_cast<long>(up ? e.hi_shown : e.lo_shown);
      least_shown += k * static_cast<long>(up ? e.lo_shown : e.hi_shown);
      state.ways[{&block, leaf}] = up == value ? 1 : -1;
    }
    const auto holds = [&](const Rational& at) { return v.strict ? sgn(at) > 0 : sgn(at) >= 0; };
    state.can = holds(value ? most : least) != value               ? no
                : holds(value ? most_shown : least_shown) == value ? yes
                                                                   : CanFail::open;
    // of several signals the extremes need not come together
    const bool one_by_one = form.terms.size() < 2 || is_charge(form);
    if (state.can == yes && !one_by_one) state.can = CanFail::open;
    // what zone will be received nobody knows
    if (state.can == yes && asks_for_received(form)) state.can = CanFail::open;
    return state;
  }
  static bool asks_for_received(const ir::Linear& form) {
    return std::any_of(form.terms.begin(), form.terms.end(),
                       [](const auto& term) { return term.first.kind == Leaf::Kind::received; });
  }
  // A battery may be empty wherever a robot is.
  static bool is_charge(const ir::Linear& form) {
    return std::all_of(form.terms.begin(), form.terms.end(), [](const auto& term) {
      return term.first.kind == Leaf::Kind::battery || term.first.kind == Leaf::Kind::energy_to;
    });
  }
  // Of the body: as far as its farthest point is from the boundary.
  [[nodiscard]] Extent clearance(const ir::ZoneTable& zone) const {
    const std::int64_t radius_mm = decision_.body.radius_mm;
    const Shape shape = shape_of(zone);
    if (!shape.bounded) {
      return {-shape.depth_mm - radius_mm, far_away, -radius_mm - 1, far_away};
    }
    // `widest_mm` is a lower bound of the greatest clearance, close to it
    const std::int64_t hi = zone.widest_mm - radius_mm;
    return {-far_away, hi + std::max<std::int64_t>(zone.widest_mm / 10, 100), -far_away, hi};
  }

  const ir::Module& module_;
  const ir::Decision& decision_;
  CanBeTold told_;
  // A part that several others share is looked at once.
  using Found = std::map<std::tuple<const ir::Block*, ir::ValueId, bool>, Any>;
  Found found_, found_told_;
};

}  // namespace

Vacuity vacuity_of(const ir::Module& module, const ir::Decision& decision,
                   const ir::Block& property, CanBeTold told) {
  if (told == CanBeTold::no) return {CanFail::no, {"no inputs make it false"}};
  Finder finder(module, decision, told);
  const Any states = finder.find(property, property.result, false);
  const auto found = std::find_if(states.begin(), states.end(), [&](const State& s) {
    return s.can == CanFail::yes && (s.told.empty() || told == CanBeTold::yes);
  });
  Vacuity out;
  if (found != states.end()) {
    out.can_fail = CanFail::yes;
    for (const auto& [of, way] : found->ways) {
      out.because.push_back(finder.text_of(of.second, way));
    }
  } else if (states.empty()) {
    out.can_fail = CanFail::no;
    out.because = finder.limits_of(property);
    out.alone = finder.is_about_nobody(property);
  }
  return out;
}

}  // namespace rtac::analysis
