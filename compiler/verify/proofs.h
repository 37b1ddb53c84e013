// How the obligations of one decision are shown. Each function returns one of them, with the claims
// that it rests on.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "compiler/analysis/arbitration.h"
#include "compiler/analysis/common_zone.h"
#include "compiler/analysis/straight_in.h"
#include "compiler/analysis/told.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"
#include "compiler/protocol/protocol.h"
#include "compiler/sema/spec.h"
#include "compiler/verify/obligation.h"

namespace rtac::verify {

// A zone, and the clearance in it at which every monitor that speaks of it gives control back.
struct Need {
  ir::ZoneIndex zone;
  std::int64_t clearance_mm;
};

// Why something is not shown, and what works, or may; without a reason it is shown. A run may show
// that it is not so.
struct Doubt {
  std::string why{}, repair{};
  bool takes_a_run = false;
  std::vector<Mend> mends{};
};

// What all proofs of a decision speak of.
struct Subject {
  const sema::Spec& spec;
  const ir::Module& module;
  const sema::Decision& written;
  const ir::Decision& decision;
  const analysis::ExactZone& exact;
  const std::function<const geometry::Solid&(ir::ZoneIndex)>& solid;  // of a zone with height
  const analysis::ZoneOf& zone_of;
  const sema::RobotKind& kind;
  bool is_read = true;  // somebody reads the texts, and not only what is shown
  std::shared_ptr<analysis::KnownPlaces> known = std::make_shared<analysis::KnownPlaces>();
  // Monitors that inputs alone make true, which then ask for no place.
  std::set<std::size_t> told{};
  [[nodiscard]] bool looks_at_places(std::size_t k) const {
    return decision.monitors[k].lookahead.duration && !told.contains(k);
  }
  [[nodiscard]] const sema::Monitor& monitor(std::size_t k) const {
    return spec[written.priority[k]];
  }
};

// Whether the recheck knows each cell of a zone of the plane to the millimetre: no corner that was
// written is off the grid, nor so far off that doubles do not tell them apart (recheck/grid.h).
bool is_on_grid(const Subject& s, ir::ZoneIndex zone);

// How P2b is refuted at a place where a robot is stuck.
inline constexpr const char* by_geometry = "geometry";

// ---- the rules of switching
Obligation decided_in_time(const Subject& s, std::size_t k);
Obligation same_output(const Subject& s);
Obligation drives_until_next(const Subject& s, std::size_t k);
Obligation starts_well(const Subject& s);
protocol::Arbitration known_turns(const Subject& s, const analysis::Arbitration& matrix);
// `check`: none while the specification has errors.
Obligation switches_well(const Subject& s, const analysis::Arbitration& matrix,
                         const protocol::CheckModel& check);

// ---- the recoveries
Obligation recovery_keeps(const Subject& s, std::size_t k);
Obligation control_returns(const Subject& s, std::size_t k);
// Whether the recovery of one monitor is as slow as the property of another one asks, whoever has
// accepted that it is not (5033); or waits while inputs ask for less.
bool slow_enough(const Subject& s, std::size_t driving, std::size_t judged);
// P2b of a recovery that waits for other robots.
Obligation makes_room(const Subject& s, std::size_t k, Obligation o);
Obligation keeps_others(const Subject& s, const analysis::Entry& entry, std::size_t driving,
                        std::size_t judged);

// From where the recovery of one monitor may lead to where another one is false, both of them
// holding at the start: for runs that show it.
std::vector<Start> starts_of_damage(const Subject& s, std::size_t driving, std::size_t judged);
std::vector<Start> starts_of_damage_in_space(const Subject& s, std::size_t driving,
                                             std::size_t judged);
// The same from where it leads to where the monitor takes over.
std::vector<Start> starts_of_take_over_in_space(const Subject& s, std::size_t driving,
                                                std::size_t judged);
// From where the recovery of a monitor leads nowhere, and control is not given back.
std::vector<Start> starts_stranded_in_space(const Subject& s, std::size_t k);
// Refuted if a run that begins there is not given back for half as long again as its legs take that
// lead to the farthest place of the zone of the recovery.
Obligation shown_from(const Subject& s, const ir::Recovery& last, Obligation o,
                      std::vector<Start> starts);
// From where robots may wait for each other for ever, one of them by `yield`, each of those places
// with all of them. `instead`: another monitor whose recovery may drive, if there is one.
std::vector<Start> lock_ups(const Subject& s, const ir::Recovery& yield,
                            const ir::Monitor* instead);
// Of two robots in the plane, which are not given back nearer to each other than so.
std::vector<Start> lock_ups_beside_walls(const Subject& s, const ir::Recovery& yield,
                                         std::int64_t kept_mm);

// P2b of a recovery that is proved to lead to its clearance of return: whether a robot that has
// come to rest there is given back, as far as its own monitor is concerned.
Obligation returned_at_rest(const Subject& s, std::size_t k, Obligation proved);

// ---- the places
std::vector<Need> needs_of(const Subject& s);
// What all monitors together ask of a place where they give control back.
struct JointNeeds {
  std::vector<Need> zones;                                          // of properties
  std::vector<Need> returned;                                       // of `return when`
  std::int64_t low_mm = std::numeric_limits<std::int32_t>::min();   // and how high the centre is
  std::int64_t high_mm = std::numeric_limits<std::int32_t>::max();  // there
  bool one_of_several = false;    // of an `or` in a `return when` one side, for which others may do
  std::vector<std::string> open;  // monitors whose `return when` asks for something else besides
};
// `at_once`: a monitor that gives back without its `return when`.
JointNeeds joint_needs_of(const Subject& s, std::optional<std::size_t> at_once = {});
// Of each `return when` that leaves no such place, in the plane: how clear of its zone it may ask
// for one with which there is one.
std::vector<Mend> earlier_returns(const Subject& s);
// Of each `or` of zones one side, in all ways, at most 64 of them; `ask` tells how clear of its
// zone a side that asks for so many mm has to be, `rest_mmps` below which speed a limit is no side.
// One way without a side: there is no such `or`.
using Sides = std::vector<Need>;
std::vector<Sides> ways_to_choose(
    const Subject& s, const std::vector<const ir::Monitor*>& monitors,
    const std::function<std::int64_t(const ir::Monitor&, std::int64_t)>& ask,
    const std::function<std::int64_t(const ir::Monitor&)>& rest_mmps = {});
// Of both.
std::vector<Need> all_of(const JointNeeds& needs);
// That the return conditions hold at a place; of decisions without any, none.
std::vector<Claim> returned_claims(const Subject& s, std::int64_t x_mm, std::int64_t y_mm,
                                   std::optional<std::int64_t> z_mm);
// Unknown, since they ask for something else.
Obligation returns_open(const JointNeeds& needs, Obligation o);
Claim place_claim(const Subject& s, ir::ZoneIndex zone, std::int64_t x_mm, std::int64_t y_mm,
                  std::int64_t clearance_mm);
// Square of the distance of a place from the boundary of a region, in m^2.
Rational square_to(const std::vector<geometry::Ring>& rings, const geometry::Point& p);
Obligation can_hold(const Subject& s, std::size_t k);
Obligation can_fail(const Subject& s, std::size_t k);
Obligation returns_together(const Subject& s);
// How one zone lies in another one, of which nothing else is asked than how deep.
analysis::HowItLies how_it_lies(const Subject& s);
// Of zones with height and of the plane, which have no ends.
analysis::ExactSolid any_solid(const Subject& s);
// Whether one zone lies in another, in the plane or in space.
bool lies_in(const Subject& s, ir::ZoneIndex inner, ir::ZoneIndex outer);
// Whether monitors ask for a height where they give control back.
bool asks_for_height(const Subject& s, const JointNeeds& needs);
// In space: a place, and whether a straight leg leads to one as clear from everywhere in a zone.
Obligation returns_together_in_space(const Subject& s, const JointNeeds& needs);
Obligation legs_back(const Subject& s, std::size_t k);
// Whether a limit of height is kept, with `gap_mm` to spare, where a recovery comes to rest as
// clear of its zone as control returns at.
bool rests_at_height(const Subject& s, const ir::Recovery& last, std::int64_t gap_mm,
                     const ir::Block& block, const ir::AtLeast& limit);

// Of `o`: no state is seen to have it, which `how` shows, or none was found. `why` has the numbers
// that are there and needed: what works is known where more is asked for, to give control back.
Obligation not_seen(Obligation o, bool never, const char* how, std::string why);
// Of `o`, that the property can be seen to hold: what keeps a limit of speed, height or charge from
// being seen to be kept in any state. none: nothing does.
std::optional<Obligation> limits_unseen(const Subject& s, const ir::Monitor& m,
                                        const Obligation& o);

// Of a decision on a plan.
std::vector<Obligation> plan_obligations(const Subject& s);

// What is seen of a robot that has come to rest, driven as `motion` has it, whatever the sample.
analysis::SeenAtRest seen_at_rest(const Subject& s, const ir::Motion& motion);
// Of what is shown for these monitors: inputs make all that they say, and ask for to let go, true
// at once. `only`: of one of them; else of all, some of which inputs alone make true.
Obligation told_at_once(const Subject& s, std::optional<std::size_t> only, Obligation proved);
// Those monitors, separated by `;`.
std::string names_of_told(const Subject& s);
// "load.0=20;door.0=1"
std::string values_of(const Subject& s, const std::vector<analysis::ToldInput>& told);

// How long the recovery of a monitor lasts and how far it drives, where a proof of charge rests on
// it: within what the energy clause reckons with.
std::optional<Claim> lasting_claim(const Subject& s, std::size_t k);

// The claim, and the cells of the zone that it speaks of; `of` ends the names of these numbers.
Claim with_cells(Claim claim, const ir::ZoneTable& zone, const std::string& of = "");
// The claim, and what ways of a recovery over the cells of its zone keep clear, where they begin,
// and how clear they lead to.
Claim with_ways(const Subject& s, Claim claim, const ir::Recovery& last);
// The integers that the kernel counts with, for a program that has its own idea of them.
Claim limits_claim(const Subject& s);
Claim lemma_claim(const std::string& lemma);

}  // namespace rtac::verify
