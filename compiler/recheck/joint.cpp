#include "compiler/recheck/joint.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "compiler/recheck/at_place.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/seen.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/told.h"
#include "compiler/sema/openings.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

class JointReturn {
 public:
  JointReturn(const sema::Spec& spec, const sema::Decision& decision, const Entry& entry,
              Claims& claims)
      : spec_(spec), d_(decision), e_(entry), claims_(claims), there_(spec, decision, claims) {}

  std::vector<std::string> run() {
    apart();
    const Claim* const told = told_at_once();
    for (std::string& why : torn_returns(spec_, d_, claims_, "", told)) fail(std::move(why));
    // which ask for no place then
    const std::set<std::string> alone = names_in(told ? text(told->values, "alone") : "");
    gone_at_once(alone);
    for (const sema::MonitorId id : d_.priority) {
      const sema::Monitor& m = spec_[id];
      if (alone.contains(m.name)) continue;
      if (asks_out_of_sight(spec_, d_, *m.always)) {
        fail("no agent is known to be as far away as `" + m.name + "` asks");
      }
      if (!m.ahead.waypoints_only && too_fast_at_rest(spec_, d_, claims_, m)) {
        fail("who rests may be too fast for `" + m.name + "` to give control back");
      }
    }
    if (has(e_, "no_fences", {{"decision", d_.name}})) {
      for (const sema::MonitorId id : d_.priority) {
        if (!spec_[id].ahead.waypoints_only) in_its_zones(spec_[id], told, {});
      }
      (void)heights_said(alone);
      charged_somewhere(alone);
    } else {
      at_a_place(told, alone);
    }
    return std::move(doubts_);
  }

 private:
  void fail(std::string why) { doubts_.push_back(std::move(why)); }
  void need(const std::string& what) {
    if (!has(e_, what, {{"decision", d_.name}})) fail("it rests on no claim `" + what + "`");
  }
  // All places that are claimed are one, and it is clear of all zones that are asked for.
  void at_a_place(const Claim* told, const std::set<std::string>& alone) {
    std::set<std::string> zones, places, named;
    std::set<std::string> heights = heights_said(alone);
    std::string height;
    Spot spot;
    const auto asks = [&](sema::MonitorId id) {
      return !spec_[id].ahead.waypoints_only && !alone.contains(spec_[id].name);
    };
    for (const sema::MonitorId id : d_.priority) {
      if (!asks(id)) continue;
      for (const sema::ZoneId zone : asked_in(spec_, *spec_[id].always)) {
        zones.insert(claims_.zones().name(zone));
      }
    }
    for (const Claim& c : e_.claims) {
      if (c.what != "place" && c.what != "returned") continue;
      if (text(c.values, "decision") != d_.name || c.values.count("robot") != 0) continue;
      places.insert(c.values.count("x_mm") + c.values.count("y_mm") == 2
                        ? c.values.at("x_mm") + " " + c.values.at("y_mm")
                        : "");
      if (c.values.count("z_mm") != 0) heights.insert(c.values.at("z_mm"));
      spot = spot_of(c);
      zones.erase(c.values.count("zone") != 0 ? c.values.at("zone") : "");
      named.insert(text(c.values, "zone"));
      if (c.what == "place") height = text(c.values, "z_mm");
    }
    for (const sema::MonitorId id : d_.priority) {
      if (asks(id)) in_its_zones(spec_[id], told, named);
    }
    if (places.empty()) need("no_fences");
    const bool asked = std::any_of(d_.priority.begin(), d_.priority.end(), [&](sema::MonitorId id) {
      return spec_[id].return_when != nullptr;
    });
    if (asked) need("returned");
    // of others that nobody has declared, all are far
    const bool has_others = std::ranges::count(spec_.robots, d_.kind, &sema::Robot::kind) > 1;
    for (const sema::MonitorId id : d_.priority) {
      const auto& when = spec_[id].return_when;
      if (!when || !has_others || !judges_robots(spec_, d_, *when) ||
          distance_asked(spec_, d_, *when))
        continue;
      fail("`return when` of `" + spec_[id].name + "` may not hold of all robots");
    }
    if (!zones.empty()) fail("nothing is said of zone `" + *zones.begin() + "`");
    if (places.size() > 1 || heights.size() > 1) fail("it is not one place");
    named.erase("");
    spot.zones = named;
    if (places.empty()) {
      charged_somewhere(alone);
    } else if (!is_charged(spot, alone)) {
      fail(too_dear);
    }
    all_at_once(named, height, alone);
  }
  static constexpr const char* too_dear = "no battery has enough for the ways from there";
  // A full battery is enough for all ways that begin there and are asked charge for.
  bool is_charged(const Spot& spot, const std::set<std::string>& alone) {
    return std::ranges::all_of(d_.priority, [&](sema::MonitorId id) {
      const sema::Monitor& m = spec_[id];
      const bool looks = !m.ahead.waypoints_only && !alone.contains(m.name);
      return (!looks || there_.gives_back(m, spot)) && there_.lets_go(m, spot);
    });
  }
  // Where no place is asked for, any will do.
  void charged_somewhere(const std::set<std::string>& alone) {
    const std::vector<Spot> sites = there_.sites();
    const bool any =
        std::ranges::any_of(sites, [&](const Spot& spot) { return is_charged(spot, alone); });
    if (!any) fail(too_dear);
  }
  // No two robots are farther apart than the box of a zone that both are held in, less the body on
  // each side.
  void apart() {
    const double radius = spec_[d_.kind].radius.value.get_d();
    double widest = std::numeric_limits<double>::infinity();
    for (const sema::MonitorId id : d_.priority) {
      for (const sema::ZoneId zone : kept_in(spec_, *spec_[id].always)) {
        if (const geometry::Region* const region = claims_.zones().region(zone)) {
          widest = std::min(widest, widest_apart(*region, radius));
        }
      }
    }
    for (const sema::MonitorId id : d_.priority) {
      const auto asked = distance_asked(spec_, d_, *spec_[id].always);
      if (asked && asked->get_d() + 2 * radius > widest) {
        fail("no two robots are so far apart as `" + spec_[id].name + "` asks");
      }
    }
  }
  // What inputs have to be for all monitors is so at once: the claim of it, if it takes one.
  const Claim* told_at_once() {
    std::vector<const Claim*> said;
    for (const Claim& c : e_.claims) {
      const bool of_all = c.what == "at_once" && c.values.count("monitor") == 0;
      if (of_all && text(c.values, "decision") == d_.name) said.push_back(&c);
    }
    if (said.empty() && asks_at_once(spec_, d_, "")) {
      fail("it rests on no claim `at_once`");
    }
    if (said.size() > 1) fail("inputs are said to be several things at once");
    return said.empty() ? nullptr : said.front();
  }
  // What a monitor says is true in these zones of a robot at rest, with inputs as they are said to
  // be. Of what speaks of none, others are far.
  void in_its_zones(const sema::Monitor& m, const Claim* told, const std::set<std::string>& zones) {
    if (!is_on_each_side(claims_.zones(), *m.always, zones)) {
      fail("nothing is said of any side of an `or`");
    }
    const auto inputs = told_inputs(spec_, told ? text(told->values, "inputs") : "");
    if (!inputs) return;  // the claim is wrong
    const Rational extra = return_extra(spec_, d_);
    for_each_part(*m.always, [&](const sema::Expr& part) {
      const bool asks_inputs = !spoken_of(spec_, part).empty();
      const bool of_places = !all_zones(part).empty() || judges_robots(spec_, d_, part);
      if (!of_places || (!asks_inputs && !sema::speaks_of_speed(part) && !is_choice(part))) return;
      const auto may_be = [&](const sema::Expr& leaf, bool value) {
        if (!spoken_of(spec_, leaf).empty()) return told == nullptr;
        const auto asked = all_zones(leaf);
        const bool missed = !asked.empty() && std::ranges::none_of(asked, [&](sema::ZoneId zone) {
          return zones.contains(claims_.zones().name(zone));
        });
        const bool near = asks_inputs && judges_robots(spec_, d_, leaf);
        return !value &&
               (missed || near || Sides(spec_, d_, claims_).is_exceeded_at_rest(leaf, m, extra));
      };
      if (told_makes_true_but(spec_, part, *inputs, may_be)) return;
      if (Sides(spec_, d_, claims_).holds_at_rest(part, m, extra)) return;
      fail("of `" + m.name + "` nothing is said of a zone");
    });
  }
  // Some of it may be false.
  static bool is_choice(const sema::Expr& part) {
    const auto* const logic = std::get_if<sema::Logic>(&part.node);
    return logic != nullptr && logic->op != sema::LogicOp::logical_and;
  }
  // Each part of an `and`.
  template <class Visit>
  static void for_each_part(const sema::Expr& e, const Visit& visit) {
    const auto* const logic = std::get_if<sema::Logic>(&e.node);
    if (logic == nullptr || logic->op != sema::LogicOp::logical_and) return visit(e);
    for (const sema::ExprPtr& each : logic->operands) for_each_part(*each, visit);
  }
  // The heights of its claims, one of which there has to be where any of these is asked for.
  std::set<std::string> heights_said(const std::set<std::string>& alone) {
    const bool high = std::ranges::any_of(d_.priority, [&](sema::MonitorId id) {
      return !alone.contains(spec_[id].name) && sema::speaks_of_height(*spec_[id].always);
    });
    if (high && !has(e_, "height", {{"decision", d_.name}})) {
      fail("nothing is said of the height");
    }
    std::set<std::string> heights;
    for (const Claim& c : e_.claims) {
      if (c.what != "height") continue;
      heights.insert(text(c.values, "z_mm"));
      if (!std::ranges::includes(alone, names_in(text(c.values, "but")))) {
        fail("it leaves out what inputs alone do not make true");
      }
    }
    return heights;
  }
  // Of what monitors ask of zones that come and go, none is there for as long as they look ahead,
  // and another minute.
  void gone_at_once(const std::set<std::string>& alone) {
    std::vector<const sema::Expr*> said;
    Rational ahead = 60;
    for (const sema::MonitorId id : d_.priority) {
      const sema::Monitor& m = spec_[id];
      if (m.ahead.waypoints_only || alone.contains(m.name)) continue;
      said.push_back(m.always.get());
      if (m.ahead.duration) ahead = std::max(ahead, Rational(m.ahead.duration->value + 60));
    }
    if (sema::are_ever_gone(spec_, said, floor_to_int(ahead))) return;
    fail("zones that come and go may never be gone at once");
  }
  // How far apart two robots are that are given back both. Neither is held then: each reckons with
  // its own reach and, from a message that is as old as it may be, with that of the other one; both
  // are measured beside where they are.
  Rational both_given_back() const {
    const sema::RobotKind& kind = spec_[d_.kind];
    const Rational heard = kind.hears_max_age ? kind.hears_max_age->value : Rational(0);
    const Rational extra = return_extra(spec_, d_);
    const Rational error = numbers_of(spec_, d_, jitter_of(spec_, d_)).position_error;
    Rational most = 0;
    for (const sema::MonitorId id : d_.priority) {
      auto asked = distance_asked(spec_, d_, *spec_[id].always);
      if (const auto& when = spec_[id].return_when) {
        const auto also = distance_asked(spec_, d_, *when);
        if (also && (!asked || *also > *asked)) asked = also;
      }
      if (!asked || *asked <= 0) continue;
      most = std::max(most,
                      Rational(*asked + 2 * error + claims_.return_clearance(d_, spec_[id], extra) +
                               claims_.return_clearance(d_, spec_[id], extra + heard)));
    }
    return most;
  }
  // Of robots that are to be so far apart each has a place in all of these zones.
  void all_at_once(const std::set<std::string>& zones, const std::string& height,
                   const std::set<std::string>& alone) {
    const auto robots = std::ranges::count(spec_.robots, d_.kind, &sema::Robot::kind);
    const Rational apart = both_given_back();
    if (robots < 2 || apart <= 0 || zones.empty()) return;
    std::vector<geometry::Point> centres;
    for (long k = 0; k < robots; ++k) {
      std::set<std::pair<std::int64_t, std::int64_t>> at;
      std::set<std::string> left = zones;
      for (const Claim& c : e_.claims) {
        if (c.what != "place" || text(c.values, "decision") != d_.name) continue;
        if (number(c.values, "robot") != k || text(c.values, "z_mm") != height) continue;
        const auto x = number(c.values, "x_mm"), y = number(c.values, "y_mm");
        if (x && y) at.emplace(*x, *y);
        left.erase(text(c.values, "zone"));
      }
      if (at.size() != 1 || !left.empty()) {
        fail("there is no place for all robots at once");
        return;
      }
      centres.push_back({milli(at.begin()->first), milli(at.begin()->second)});
      if (!is_charged({centres.back(), std::nullopt, zones}, alone)) fail(too_dear);
    }
    for (std::size_t k = 1; k < centres.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        const Rational dx = centres[k].x - centres[j].x, dy = centres[k].y - centres[j].y;
        if (dx * dx + dy * dy >= apart * apart) continue;
        fail("two of its robots are too near to each other");
        return;
      }
    }
  }

  const sema::Spec& spec_;
  const sema::Decision& d_;
  const Entry& e_;
  Claims& claims_;
  AtPlace there_;
  std::vector<std::string> doubts_;
};

}  // namespace

std::vector<std::string> doubts_of_return(const sema::Spec& spec, const sema::Decision& decision,
                                          const Entry& entry, Claims& claims) {
  return JointReturn(spec, decision, entry, claims).run();
}

std::vector<std::string> torn_returns(const sema::Spec& spec, const sema::Decision& decision,
                                      Claims& claims, const std::string& only, const Claim* told) {
  std::vector<std::string> doubts;
  const auto inputs = told_inputs(spec, told != nullptr ? text(told->values, "inputs") : "");
  for (const sema::MonitorId id : decision.priority) {
    const sema::Monitor& m = spec[id];
    if (!m.return_when || (!only.empty() && m.name != only)) continue;
    const auto at_rest = [&](const sema::Expr& part) {
      return is_limit_kept_at_rest(spec, decision, claims, m, part);
    };
    for (const sema::Expr* part : torn_parts(spec, *m.return_when, at_rest)) {
      if (inputs && told_alone_makes(spec, *part, *inputs)) continue;
      doubts.push_back("`return when` of `" + m.name +
                       "` may ask for inputs and places that are not at once");
    }
  }
  return doubts;
}

}  // namespace rtac::recheck
