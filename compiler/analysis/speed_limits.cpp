#include "compiler/analysis/speed_limits.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "compiler/analysis/dials.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/paces.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/timing.h"
#include "compiler/analysis/travel.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

std::string speed_text(std::int64_t mmps) {
  return to_decimal(Rational(mmps, 1000)) + " m/s";
}

constexpr const char* never_given_back = "` can never hand control back: ";

bool asks_for_no_more_than(std::int64_t mmps, const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return asks_for_no_more_than(mmps, block, v->a) && asks_for_no_more_than(mmps, block, v->b);
  }
  if (const auto* v = std::get_if<ir::Or>(&op)) {
    return asks_for_no_more_than(mmps, block, v->a) || asks_for_no_more_than(mmps, block, v->b);
  }
  // what it says of its own speed, whichever the other one is
  if (const auto* each = std::get_if<ir::ForOthers>(&op)) {
    return each->universal && asks_for_no_more_than(mmps, *each->body, each->body->result);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  const auto most = compare ? ir::upper_bound(block, *compare) : std::nullopt;
  return most && most->leaf.kind == ir::Leaf::Kind::speed && mmps <= most->most;
}

// Wherever the robot is, where agents are as far off as a side asks.
bool holds_far_from_agents(const ir::Decision& decision, const ir::Block& block, ir::ValueId id) {
  const auto far = [&](ir::ValueId side) { return holds_far_from_agents(decision, block, side); };
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) return far(v->a) && far(v->b);
  if (const auto* v = std::get_if<ir::Or>(&op)) return far(v->a) || far(v->b);
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  const auto bound =
      compare ? ir::lower_bound(block, *compare, decision.facts.params) : std::nullopt;
  return bound && bound->leaf.kind == ir::Leaf::Kind::agent;
}

bool speaks_of_agents(const ir::Block& block, ir::ValueId id) {
  const auto of = [&](ir::ValueId part) { return speaks_of_agents(block, part); };
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) return of(v->a) || of(v->b);
  if (const auto* v = std::get_if<ir::Or>(&op)) return of(v->a) || of(v->b);
  if (const auto* v = std::get_if<ir::Not>(&op)) return of(v->a);
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (const ir::Block* others = ir::body_of(op)) return speaks_of_agents(*others, others->result);
  if (compare == nullptr) return false;
  const auto& terms = ir::linear_form(block, *compare).terms;
  return std::ranges::any_of(
      terms, [](const auto& term) { return term.first.kind == ir::Leaf::Kind::agent; });
}

// The gate looks as far as the monitors of agents do.
bool looks_far_enough(const ir::Monitor& monitor) {
  const ir::Lookahead& ahead = monitor.lookahead;
  return ahead.duration && !ahead.too_short && !ahead.points_only;
}

bool is_slow_beside_agents(const ir::Decision& decision, const ir::Block& block, ir::ValueId id) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    return is_slow_beside_agents(decision, block, v->a) &&
           is_slow_beside_agents(decision, block, v->b);
  }
  return !speaks_of_agents(block, id) ||
         (holds_far_from_agents(decision, block, id) &&
          asks_for_no_more_than(decision.body.stands_mmps, block, id));
}

// The limits of speed in the property of one monitor. What an `or` leaves open is a limit only
// where nothing else of it holds.
class Limits {
 public:
  Limits(const Decided& of, std::size_t k)
      : of_(of),
        decision_(of.decision),
        monitor_(of.decision.monitors[k]),
        written_(of.spec[of.written.priority[k]]),
        block_(monitor_.property),
        need_mmps_(fastest_from_rest(decision_, monitor_.lookahead.duration_us)) {}

  std::vector<diag::Diagnostic> run() {
    look(block_.result);
    return std::move(found_);
  }
  [[nodiscard]] bool kept_by(std::size_t k, ir::ValueId id) const {
    if (const auto* v = std::get_if<ir::And>(&block_[id].op)) {
      return kept_by(k, v->a) && kept_by(k, v->b);
    }
    return !first(id) || keeps(k, id);
  }
  [[nodiscard]] bool kept_by(std::size_t k) const { return kept_by(k, block_.result); }
  // With which `fault` is gone, that it may be faster than a limit while it is held.
  [[nodiscard]] std::vector<std::string> slow_enough_held(const Fault& fault) const {
    const std::int64_t stands_mmps = decision_.body.stands_mmps;
    const auto limit = first_beside_agents(block_.result, stands_mmps);
    if (!limit) return {};
    std::vector<std::string> works;
    if (const auto higher = limit_that_works(fault, *limit, stands_mmps)) {
      works.push_back("a limit of " + speed_text(*higher));
    }
    const auto others = repairs(of_.written, of_.trials, fault, [&](const Trial& t) {
      return t.decision.body.stands_mmps <= limit->most_mmps;
    });
    works.insert(works.end(), others.begin(), others.end());
    return works;
  }

 private:
  struct Limit {
    const ir::Value* value;
    std::int64_t most_mmps;
  };
  [[nodiscard]] std::optional<Limit> limit(ir::ValueId id) const {
    const auto* compare = std::get_if<ir::AtLeast>(&block_[id].op);
    const auto bound = compare ? ir::upper_bound(block_, *compare) : std::nullopt;
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::speed) return std::nullopt;
    return Limit{&block_[id], bound->most};
  }
  // The first one below that does not allow `mmps`; none: the value is none of the speed.
  [[nodiscard]] std::optional<Limit> first(
      ir::ValueId id, std::int64_t mmps = std::numeric_limits<std::int64_t>::max()) const {
    const ir::Op& op = block_[id].op;
    const auto either = [&](ir::ValueId a, ir::ValueId b) {
      const auto left = first(a, mmps);
      return left ? left : first(b, mmps);
    };
    if (const auto* v = std::get_if<ir::And>(&op)) return either(v->a, v->b);
    if (const auto* v = std::get_if<ir::Or>(&op)) return either(v->a, v->b);
    const auto own = limit(id);
    return own && own->most_mmps < mmps ? own : std::nullopt;
  }

  // The first such limit of what speaks of agents, and would be kept by who stands still.
  [[nodiscard]] std::optional<Limit> first_beside_agents(ir::ValueId id, std::int64_t mmps) const {
    if (const auto* v = std::get_if<ir::And>(&block_[id].op)) {
      const auto left = first_beside_agents(v->a, mmps);
      return left ? left : first_beside_agents(v->b, mmps);
    }
    const bool helps = speaks_of_agents(block_, id) && asks_for_no_more_than(0, block_, id);
    return helps ? first(id, mmps) : std::nullopt;
  }

  void look(ir::ValueId id) {
    if (const auto* v = std::get_if<ir::And>(&block_[id].op)) {
      look(v->a);
      look(v->b);
      return;
    }
    const std::optional<Limit> limit = first(id);
    if (!limit) return;
    if (!returns(id)) return report_no_return(*limit);
    for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
      const std::string& name = decision_.monitors[k].recovery.name;
      if (keeps(k, id) || ir::acknowledged(decision_, name, monitor_.name)) continue;
      const auto exceeded = first(id, fastest_while_driving(decision_, k));
      if (exceeded) {
        report_too_fast(*exceeded, k, std::holds_alternative<ir::Or>(block_[id].op));
      } else if (!has_parameter()) {
        report_unknown(*limit, k);
      }
    }
  }
  // Whether some place or other lets control return, as far as speeds are concerned.
  [[nodiscard]] bool returns(ir::ValueId id) const {
    const ir::Op& op = block_[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) return returns(v->a) && returns(v->b);
    if (const auto* v = std::get_if<ir::Or>(&op)) return returns(v->a) || returns(v->b);
    const auto own = limit(id);
    return !own || need_mmps_ <= own->most_mmps;
  }
  // How far a recovery keeps it: by its speed, or in a zone that it stays in.
  [[nodiscard]] Pace pace(std::size_t k, ir::ValueId id) const {
    return pace_of(block_, id, fastest_while_driving(decision_, k), need_mmps_,
                   [&](const ir::Block& block, const ir::AtLeast& compare) {
                     return stays_in(k, block, compare);
                   });
  }
  [[nodiscard]] bool stays_in(std::size_t k, const ir::Block& block,
                              const ir::AtLeast& compare) const {
    const auto bound = ir::lower_bound(block, compare, decision_.facts.params);
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) return false;
    const Standoff fence{ir::ZoneIndex{bound->leaf.table}, bound->need.strictest};
    const auto inside = [&](const ir::Recovery* step) {
      return ir::moves(step->kind) &&
             (step->zone == fence.zone ? fence.mm <= 0 : of_.lies(step->zone, fence) == Lies::deep);
    };
    const auto steps = ir::steps_of(decision_.monitors[k].recovery);
    return std::all_of(steps.begin(), steps.end(), inside);
  }
  // No limit is exceeded, and what else counts are zones and what the robot is told: where the
  // recovery may move is not about its speed (5016, 6005).
  [[nodiscard]] bool is_of_zones(std::size_t k, ir::ValueId id) const {
    const ir::Op& op = block_[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) {
      return is_of_zones(k, v->a) && is_of_zones(k, v->b);
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      return is_of_zones(k, v->a) && is_of_zones(k, v->b);
    }
    if (const auto own = limit(id)) return fastest_while_driving(decision_, k) <= own->most_mmps;
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (compare == nullptr) return told(block_, id);
    const auto bound = ir::lower_bound(block_, *compare, decision_.facts.params);
    return bound && bound->leaf.kind == ir::Leaf::Kind::clearance;
  }
  // Of a limit that counts while the robot is told so, others than the monitor's own recovery are a
  // matter of who takes over (6005).
  [[nodiscard]] bool keeps(std::size_t k, ir::ValueId id) const {
    if (is_of_zones(k, id)) return true;
    if (yields_to_agents(k, id)) return true;
    const Pace found = pace(k, id);
    if (found != Pace::while_told) return found != Pace::broken;
    return decision_.monitors[k].recovery.name != monitor_.recovery.name;
  }

  // Its own recovery drives in place of that one as soon as it may be false.
  [[nodiscard]] bool is_taken_over(std::size_t k) const {
    return &decision_.monitors[k] > &monitor_ && !decision_.coordinated &&
           decision_.monitors[k].recovery.name != monitor_.recovery.name;
  }
  // Who comes near has its own recovery drive, or the gate stop this one, which is slow enough
  // then.
  [[nodiscard]] bool yields_to_agents(std::size_t k, ir::ValueId id) const {
    if (!holds_far_from_agents(decision_, block_, id)) return false;
    const bool obeys = decision_.monitors[k].recovery.kind != ir::RecoveryKind::external;
    return is_taken_over(k) || (obeys && looks_far_enough(monitor_) &&
                                asks_for_no_more_than(decision_.body.stands_mmps, block_, id));
  }

  void report_no_return(const Limit& limit) {
    std::int64_t works_mmps = fastest_from_hold(decision_, monitor_.lookahead.duration_us);
    for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
      const std::string& name = decision_.monitors[k].recovery.name;
      if (ir::acknowledged(decision_, name, monitor_.name)) continue;
      works_mmps = std::max(works_mmps, fastest_while_driving(decision_, k));
    }
    const auto others = repairs(of_.written, of_.trials, fault(limit), [&](const Trial& t) {
      const std::int64_t ahead_us = lookahead_us(of_.spec, written_, t.decision.period_us);
      return fastest_from_hold(t.decision, ahead_us) <= limit.most_mmps;
    });
    // at the declared speed it would find nothing (7004)
    const auto higher = limit_that_works(limit, works_mmps);
    std::string help = higher ? "a limit of " + speed_text(*higher) + " works" : "";
    if (!others.empty()) {
      help += (help.empty() ? "" : "; ") + ("for control to return, " + joined(others) + " works");
    }
    if (help.empty()) {
      help =
          "no limit below the declared speed works: less error, a lower `accel`, or samples, a "
          "latency and an `ahead` that are shorter";
    }
    report(limit,
           "monitor `" + monitor_.name + never_given_back +
               from_rest_text(of_.spec[of_.written.kind], need_mmps_),
           std::move(help));
  }
  void report_too_fast(const Limit& limit, std::size_t k, bool of_a_choice) {
    const std::string& name = decision_.monitors[k].recovery.name;
    const std::int64_t mmps = fastest_while_driving(decision_, k);
    // a recovery is no slower than it takes to make way
    const ir::Body& body = decision_.body;
    const std::int64_t slower_mmps = slower_for(limit.most_mmps);
    const std::int64_t least_mmps = 2 * (body.velocity_error_mmps + decision_.pushed_mmps);
    const auto slower =
        slower_mmps >= std::max<std::int64_t>(1, least_mmps)
            ? recovery_that_works(limit, decision_.monitors[k].recovery, slower_mmps)
            : std::nullopt;
    const auto higher = slower ? std::nullopt : limit_that_works(limit, mmps);
    const std::string works = slower   ? *slower + "; or "
                              : higher ? "a limit of " + speed_text(*higher) + " works; or "
                                       : "";
    report(limit,
           "the recovery `" + name + "` drives at up to " + speed_text(mmps) + ", and `" +
               monitor_.name + "` allows " + speed_text(limit.most_mmps) +
               (of_a_choice ? " where nothing else of the `or` holds" : ""),
           works + "`acknowledge " + name + " may break " + monitor_.name + " \"why\"`" +
               (works.empty() ? " works" : ""));
    name_pair(name);
  }
  // A limit that is a parameter is none that can be looked ahead at (5006).
  [[nodiscard]] bool has_parameter() const {
    bool found = false;
    ir::for_each_comparison(block_, [&](const ir::Block& block, const ir::AtLeast& compare) {
      const ir::Linear form = ir::linear_form(block, compare);
      const bool of_speed =
          form.terms.size() == 1 && form.terms.begin()->first.kind == ir::Leaf::Kind::speed;
      found = found || (of_speed && !form.rest.params.empty());
    });
    return found;
  }
  // No number is exceeded, and what else counts need not be kept.
  void report_unknown(const Limit& limit, std::size_t k) {
    const std::string& name = decision_.monitors[k].recovery.name;
    report(limit,
           "the recovery `" + name + "` drives at up to " +
               speed_text(fastest_while_driving(decision_, k)) + ", and `" + monitor_.name +
               "` is not shown to allow that",
           "`acknowledge " + name + " may break " + monitor_.name + " \"why\"` works");
    name_pair(name);
  }
  // Of a recovery of another monitor.
  void name_pair(const std::string& recovery) {
    if (recovery == monitor_.recovery.name) return;
    found_.back().monitor = monitor_.name;
    found_.back().recovery = recovery;
  }
  [[nodiscard]] Fault fault(const Limit& limit) const {
    return fault_of(diag::Code::speed_limit_unkept, limit.value->source);
  }
  [[nodiscard]] std::optional<std::int64_t> limit_that_works(const Limit& limit,
                                                             std::int64_t guess_mmps) const {
    return limit_that_works(fault(limit), limit, guess_mmps);
  }
  [[nodiscard]] std::optional<std::int64_t> limit_that_works(const Fault& fault, const Limit& limit,
                                                             std::int64_t guess_mmps) const {
    const std::int64_t declared_mmps = decision_.motions[0].speed_mmps;
    if (of_.trials == nullptr || guess_mmps >= declared_mmps) return std::nullopt;
    return asked_that_works(*of_.trials,
                            {fault, 1000, limit.most_mmps, guess_mmps, declared_mmps - 1},
                            limit.value->source);
  }
  [[nodiscard]] std::optional<std::string> recovery_that_works(const Limit& limit,
                                                               const ir::Recovery& recovery,
                                                               std::int64_t guess_mmps) const {
    if (of_.trials == nullptr) return std::nullopt;
    return recovery_speed_that_works(
        *of_.trials, {fault(limit), 1000, recovery.speed_mmps, guess_mmps, 1}, recovery.name);
  }
  // What a recovery may mean to drive at so that it is never faster than that.
  [[nodiscard]] std::int64_t slower_for(std::int64_t most_mmps) const {
    std::int64_t low = 0, high = most_mmps;
    while (low < high) {
      const std::int64_t middle = (low + high + 1) / 2;
      if (fastest_mmps(decision_.body, decision_.pushed_mmps, decision_.period_us, middle) <=
          most_mmps) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
  void report(const Limit& limit, std::string message, std::string help) {
    found_.push_back({diag::Code::speed_limit_unkept,
                      limit.value->source,
                      std::move(message),
                      "",
                      {},
                      std::move(help),
                      {}});
  }

  const Decided& of_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const sema::Monitor& written_;
  const ir::Block& block_;
  const std::int64_t need_mmps_;
  std::vector<diag::Diagnostic> found_;
};

}  // namespace

std::int64_t least_limit_mmps(const ir::Block& property) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto most = ir::upper_bound(block, compare);
    if (most && most->leaf.kind == ir::Leaf::Kind::speed) least = std::min(least, most->most);
  });
  return least;
}

bool keeps_speed_limits(const Decided& of, std::size_t driving, std::size_t judged) {
  return Limits(of, judged).kept_by(driving);
}

namespace {

// How fast a point mass may be that holds its place: pushes and errors that turn around keep it
// moving. Wheels stand.
std::int64_t holding_mmps(const ir::Decision& decision) {
  const ir::Body& b = decision.body;
  return b.brake_late_ms == 0 ? 0 : hold_speed_mmps(b, decision.period_us);
}

}  // namespace

// It is measured to have the error of the velocity more than it has, which counts once more, and
// each component lies on the grid.
std::int64_t fastest_from_rest(const ir::Decision& decision, std::int64_t lookahead_us) {
  constexpr std::int64_t grid_mmps = 4;
  const ir::Body& body = decision.body;
  const std::int64_t us = horizon_us_max(body, lookahead_us) + decision.return_extra_us;
  // theory, horizon: stamps that differ add to the error of the velocity
  const std::int64_t apart_us = std::max(body.position_age_us, body.velocity_age_us);
  const Rational speeds_up(static_cast<long>(decision.motions[0].accel_mmps2));
  const Rational changes(static_cast<long>(body.accel_mmps2));
  const Rational gained = (speeds_up * us + changes * apart_us) / 1'000'000;
  const std::int64_t mmps = 2 * body.velocity_error_mmps + grid_mmps + ceil_to_int(gained);
  return std::min(decision.motions[0].speed_mmps, mmps);
}

std::int64_t fastest_from_hold(const ir::Decision& decision, std::int64_t lookahead_us) {
  return std::min(decision.motions[0].speed_mmps,
                  holding_mmps(decision) + fastest_from_rest(decision, lookahead_us));
}

std::string from_rest_text(const sema::RobotKind& kind, std::int64_t mmps) {
  const std::string until = speed_text(mmps) + " before a recovery acts";
  if (!kind.motion.turn) return "from rest the robot may reach " + until;
  return "from rest the look-ahead takes it for up to " + until +
         ", as it counts turning like speeding up";
}

std::int64_t fastest_while_driving(const ir::Decision& decision, std::size_t k) {
  const std::int64_t declared_mmps = decision.motions[0].speed_mmps;
  const std::int64_t mmps = decision.motions[k + 1].speed_mmps;
  return std::min(declared_mmps, std::max(mmps, holding_mmps(decision)));
}

bool is_slow_beside_agents(const ir::Decision& decision, const ir::Monitor& monitor) {
  return looks_far_enough(monitor) &&
         is_slow_beside_agents(decision, monitor.property, monitor.property.result);
}

bool holds_at_rest(const ir::Decision& decision, const ir::Monitor& monitor) {
  const std::int64_t mmps = fastest_from_rest(decision, monitor.lookahead.duration_us);
  return asks_for_no_more_than(mmps, monitor.property, monitor.property.result);
}

bool holds_held(const ir::Decision& decision, const ir::Monitor& monitor) {
  return asks_for_no_more_than(decision.body.stands_mmps, monitor.property,
                               monitor.property.result);
}

bool holds_in_hold(const ir::Decision& decision, const ir::Monitor& monitor) {
  const std::int64_t mmps = fastest_from_hold(decision, monitor.lookahead.duration_us);
  return asks_for_no_more_than(mmps, monitor.property, monitor.property.result);
}

bool holds_while_driving(const ir::Decision& decision, std::size_t k, const ir::Monitor& monitor) {
  return holds_at_rest(decision, monitor) &&
         asks_for_no_more_than(fastest_while_driving(decision, k), monitor.property,
                               monitor.property.result);
}

bool holds_standing(const ir::Monitor& monitor) {
  return asks_for_no_more_than(0, monitor.property, monitor.property.result);
}

std::vector<std::string> held_that_works(const Decided& of, std::size_t k, const Fault& fault) {
  return Limits(of, k).slow_enough_held(fault);
}

std::vector<diag::Diagnostic> unkept_speed_limits(const Decided& of) {
  std::vector<diag::Diagnostic> all;
  for (std::size_t k = 0; k < of.decision.monitors.size(); ++k) {
    for (diag::Diagnostic& found : Limits(of, k).run()) all.push_back(std::move(found));
  }
  return all;
}

bool is_too_fast_at_rest(const diag::Diagnostic& report) {
  return report.code == diag::Code::speed_limit_unkept &&
         report.message.find(never_given_back) != std::string::npos;
}

}  // namespace rtac::analysis
