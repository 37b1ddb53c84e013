// The safe controllers of a robot that is simulated.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "case.h"
#include "rtac/safe/claim.h"
#include "rtac/safe/controllers.h"
#include "rtac/safe/level.h"
#include "rtac/safe/space.h"
#include "run.h"
#include "taped.h"
#include "unverified.h"

namespace rtac::simulate {

template <class Output>
class Recoveries {
 public:
  using Safe = SafeController<Output>;
  // All of it outlives what is made.
  Recoveries(const DecisionCase& decision, const Setup& setup, TimeUs jitter_us,
             const sim::Arena& arena, sim::Tape& tape)
      : decision_(decision), setup_(setup), jitter_us_(jitter_us), arena_(arena), tape_(tape) {}

  // nullptr: it is none that is known here.
  std::unique_ptr<Safe> make(const Recovery& r, int robot) {
    safe::Setting s;
    s.limits = decision_.limits;
    s.period_us = decision_.period_us;
    if (r.kind == "brake_and_hold") return std::make_unique<safe::BrakeAndHold<Output>>(s);
    if (r.kind == "sequence") return sequence(r, robot);
    if (r.kind == "extern") return external(r, s, robot);
    s.speed_mps = r.speed_mps;
    if (r.kind != "land") s.zone = &zone_of(r);  // which there may be none of
    s.route_clearance_m = r.route_clearance_m;
    s.return_clearance_m = r.return_clearance_m;
    s.pass_gap_m = r.pass_gap_m;
    if (r.has_detour) s.detour_m = r.detour_m;
    if (s.limits.in_space) return in_space<Output>(r, s, robot);
    if (r.kind == "retreat") return std::make_unique<safe::Retreat<Output>>(s);
    if (r.kind == "loiter") return std::make_unique<safe::Loiter<Output>>(s);
    if (r.kind == "yield") return std::make_unique<safe::Yield<Output>>(s);
    if (r.kind != "route") return nullptr;
    return std::make_unique<safe::Route<Output>>(s, site_of(r, robot));
  }

 private:
  [[nodiscard]] Vec2 site_of(const Recovery& r, int robot) const {
    const auto& places = decision_.surroundings.sites[static_cast<std::size_t>(r.site)];
    return places[static_cast<std::size_t>(robot)];
  }
  [[nodiscard]] const ZoneView& zone_of(const Recovery& r) const {
    return decision_.surroundings.zones[static_cast<std::size_t>(r.zone)];
  }

  // nullptr: its zone has no height.
  [[nodiscard]] const SolidView* solid_of(const Recovery& r) const {
    const SolidView& solid = decision_.surroundings.solids[static_cast<std::size_t>(r.zone)];
    return solid.slab_count > 0 ? &solid : nullptr;
  }

  // What moves in space commands accelerations.
  template <class Command>
  std::unique_ptr<SafeController<Command>> in_space(const Recovery& r, safe::Setting& s,
                                                    int robot) const {
    if constexpr (std::is_same_v<Command, Acceleration>) {
      s.land_at_m = r.land_at_m;
      if (r.kind != "land") s.solid = solid_of(r);
      if (r.kind == "retreat") return std::make_unique<safe::RetreatInSpace>(s);
      if (r.kind == "loiter") return std::make_unique<safe::LoiterInSpace>(s);
      if (r.kind == "land") return std::make_unique<safe::Land>(s);
      if (r.kind == "yield") return std::make_unique<safe::YieldInSpace>(s);
      if (r.kind == "route") return std::make_unique<safe::RouteInSpace>(s, site_of(r, robot));
    }
    return nullptr;
  }

  std::unique_ptr<Safe> sequence(const Recovery& r, int robot) {
    std::vector<safe::Step<Output>> steps;
    for (const Recovery& each : r.steps) {
      steps.push_back({make(each, robot), each.lasts_us});
      if (steps.back().controller == nullptr) return nullptr;
    }
    if (steps.empty()) return nullptr;
    return std::make_unique<safe::Sequence<Output>>(std::move(steps));
  }

  // An attack in the place of what the application brings along, behind the check of its claim.
  std::unique_ptr<Safe> external(const Recovery& r, const safe::Setting& s, int robot) {
    constexpr std::uint64_t stream = 3004;
    const auto number = static_cast<std::uint64_t>(robot) + (made_++ << 16);
    const std::uint64_t seed = sim::Random::stream(setup_.seed, stream, number).next();
    const sim::Aim aim = setup_.of_robot[static_cast<std::size_t>(robot)]->aim;
    const TimeUs acts_us = decision_.period_us + decision_.limits.latency_us + jitter_us_;
    auto attack =
        std::make_unique<Unverified<Output>>(arena_, robot, aim, r.speed_mps, acts_us, seed);
    auto driven = std::make_unique<AsRecovery<Output>>(
        std::make_unique<Taped<Output>>(std::move(attack), "recover", robot, tape_));
    if (!r.claim) return driven;
    safe::Claim claim = *r.claim;
    claim.zone = &zone_of(r);
    claim.solid = solid_of(r);
    claim.speed_mps = r.speed_mps;
    auto claimed = std::make_unique<safe::Claimed<Output>>(s, claim);
    claimed->attach(*driven);
    externals_.push_back(std::move(driven));
    return claimed;
  }

  const DecisionCase& decision_;
  const Setup& setup_;
  TimeUs jitter_us_;
  const sim::Arena& arena_;
  sim::Tape& tape_;
  std::vector<std::unique_ptr<Safe>> externals_;
  std::uint64_t made_ = 0;  // of external ones
};

}  // namespace rtac::simulate
