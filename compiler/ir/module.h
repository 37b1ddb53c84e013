// The decision IR: what a kernel computes, on integers, with every number resolved.
// A module holds constant tables (zones, ways to sites), the limits of each kind of robot, and per
// decision its monitors. A monitor is a few blocks; a block is straight-line code in SSA form.
// Canonical text: printer.h. Well-formedness: verifier.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/ir/tables.h"
#include "compiler/ir/unit.h"
#include "compiler/support/source.h"

namespace rtac::ir {

enum class ValueId : std::uint32_t {};

// ---- limits, rounded to the safe side -----------------------------------------------------------

struct Body {
  std::int64_t radius_mm = 0, position_error_mm = 0, velocity_error_mmps = 0;
  std::int64_t accel_mmps2 = 0;  // planar, turning included
  std::int64_t brake_mmps2 = 0;
  // A stop ends beside the straight one by a time at the speed that it begins with, by a share of
  // the straight stop, and by what its hold may be away.
  std::int64_t brake_lag_ms = 0, brake_lag_permille = 0, hold_mm = 0;
  std::int64_t brake_late_ms = 0;  // how much later samples and noise let the brake end
  std::int64_t position_age_us = 0, velocity_age_us = 0, battery_age_us = 0, hears_age_us = 0;
  std::int64_t latency_us = 0, tracking_mm = 0;
  std::int64_t end_reach_mm = 0;  // how far from where a recovery leads it may come to rest
  std::int64_t sway_mm = 0;       // how far from the place that it holds it may rest, for good
  std::optional<std::int64_t> heading_age_us;  // none: not sensed
  std::int64_t battery_error_ppm = 0, drain_ppm_per_s = 0;
  std::int64_t jitter_us = 0;          // a step of the decision may come this much later than due
  std::int64_t disturbance_mmps2 = 0;  // of whatever pushes it; below its brake
  // Of commands: the robot follows those up to `command_mmps2`, within the error, what pushes it
  // included.
  std::int64_t command_mmps2 = 0, command_error_mmps2 = 0;
  // A robot that is told to stop counts as standing up to here: as fast as the hold may be that the
  // sampled brake turns into, which stays within `hold_mm`. What commands a speed ends in 0.
  std::int64_t stands_mmps = 1;
  bool in_space = false;  // it moves up and down as well: all lengths above are of space
};
// A dock charges whom it finds at rest, and who holds its place there though that lets it sway
// faster (language rule 6.7).
inline constexpr std::int64_t rests_mmps = 20;
inline std::int64_t charged_up_to_mmps(const Body& b) {
  return std::max(rests_mmps, b.stands_mmps);
}
inline bool is_charged_swaying(const Body& b) {
  return b.drain_ppm_per_s > 0 && b.stands_mmps > rests_mmps;
}
// What pushes the robot adds this share to its stopping distance, d / (b - d), and bends it away by
// as much. theory, the brake: d s^2 / (2 b (b - d)) = s^2 / (2 b) d / (b - d)
inline std::int64_t sway_permille(const Body& b) {
  const std::int64_t left_mmps2 = b.brake_mmps2 - b.disturbance_mmps2;
  return b.disturbance_mmps2 == 0 ? 0 : (1000 * b.disturbance_mmps2 + left_mmps2 - 1) / left_mmps2;
}
// How much longer than s1 / (b - d) it takes until the sampled brake has turned into a hold: until
// the speed is at most `stands_mmps` for good. Sampled brake: eta = b lag; |v| falls by b sqrt(1 -
// (eta / |v|)^2) - d at least, since the command is off by eta at most; that is half of b - d at
// least where |v| is eta sqrt(2 b / (b - d)) or more, and the time that is lost is 2 b eta /
// (b - d)^2 at most.
inline std::int64_t still_lag_ms(const Body& b) {
  // undisturbed it loses nothing: the integral of dv / (b sqrt(1 - (eta / v)^2)) is below s1 / b
  if (b.disturbance_mmps2 == 0) return b.brake_late_ms;
  return (b.brake_late_ms * 2 * (1000 + sway_permille(b)) + 999) / 1000;
}
struct Motion {
  std::string name;  // "any" or the name of the recovery
  std::int64_t speed_mmps = 0, accel_mmps2 = 0;
  bool recovery = false;
  SourceRange source;          // where the speed is declared
  std::int64_t beside_mm = 0;  // how far beside its leg a recovery comes
};

// ---- values -------------------------------------------------------------------------------------

// Quantities: intervals on the grid.
struct Const {
  std::int64_t value;
};
struct Battery {};
struct Clearance {
  ZoneIndex zone;
};
struct Distance {};     // to the robot of the enclosing for_others
struct AgentDistance {  // to an agent of the decision; absent: agent_far_mm
  AgentIndex agent;
};
struct ReceivedClearance {  // of a zone of Decision::facts, as it was received last
  ReceivedIndex received;
};
struct EnergyTo {
  SiteIndex site;
};
struct Speed {};     // of the robot itself
struct Altitude {};  // of its centre, in space
struct Add {
  ValueId a, b;
};
struct Negate {
  ValueId a;
};
struct Scale {  // a * num / den, den > 0
  ValueId a;
  std::int64_t num, den;
};
// Margins, judged now.
struct AtLeast {  // a >= b; strict: a > b
  ValueId a, b;
  bool strict;
};
struct PlanInZone {  // every way-point and leg of a proposed plan
  ZoneIndex zone;
};
struct Truth {
  bool value;
};
struct Not {
  ValueId a;
};
struct And {
  ValueId a, b;
};
struct Or {
  ValueId a, b;
};
struct HeldFor {
  ValueId a;
  std::int64_t ticks;
  std::uint32_t slot;  // of the counters in the state
};
struct Block;
struct ForOthers {
  bool universal;
  std::unique_ptr<Block> body;
};
// How many other robots satisfy it: the lower end counts those that surely do, the upper end those
// that do not surely fail. Compared with constants only.
struct CountOthers {
  std::unique_ptr<Block> body;
};
// Margins over everything within reach, made by the look-ahead pass.
// `more`: what parameters add to the constant, a quantity of its unit.
struct ZoneReach {
  ZoneIndex zone;
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
struct LegsInZone {
  ZoneIndex zone;
  std::int64_t legs, need_mm;
  std::optional<ValueId> more{};
};
struct PointsInZone {
  ZoneIndex zone;
  std::int64_t points, need_mm;
  std::optional<ValueId> more{};
};
struct PairReach {
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
// The same under the commands that are known and the one that is proposed; false where they are
// not.
struct ZoneCourse {
  ZoneIndex zone;
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
struct PairCourse {
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
struct AgentReach {  // until the robot stands; true where the agent is absent
  AgentIndex agent;
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
// The same of a zone that is received, which is taken to stay as it is meanwhile.
struct ReceivedReach {
  ReceivedIndex received;
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
struct ReceivedCourse {
  ReceivedIndex received;
  std::int64_t least_mm;
  std::optional<ValueId> more{};
};
struct LegsApart {
  std::int64_t legs, need_mm;
  bool ranked;  // the robot with the smaller index goes first
  std::optional<ValueId> more{};
};
struct OnTrack {  // the robot is where its plan assumes it to be
  std::int64_t tracking_mm;
};
struct EnergyReach {
  SiteIndex site;
  std::int64_t reserve_ppm;
  std::optional<ValueId> more{};
};
struct ChargeReach {  // the charge stays above a constant
  std::int64_t least_ppm;
  std::optional<ValueId> more{};
};
// Of a zone that is there at certain times, by its schedule in Decision::facts: now; and all of the
// time from the sample until `after_us` past the horizon.
struct ZoneThere {
  ScheduleIndex schedule;
};
struct ThereThroughout {
  ScheduleIndex schedule;
  std::int64_t after_us;
};
struct GoneThroughout {
  ScheduleIndex schedule;
  std::int64_t after_us;
};
struct SpeedReach {  // the robot is never faster
  std::int64_t most_mmps;
};
struct AltitudeReach {  // its centre is never above the limit, or never below it
  std::int64_t limit_mm;
  bool above;  // it has to stay above
};
struct Fact {  // a margin: what Decision::facts judges under this index, once a tick
  std::uint32_t index;
  bool of_robot = false;  // it speaks of what robots sense, now or in the past
};

// ---- of monitors without a robot: inputs, arithmetic, the past

struct Input {  // a quantity; channel: index into Watch::inputs
  std::uint32_t channel, component;
};
struct InputTruth {  // a margin
  std::uint32_t channel, component;
};
struct InputIs {  // a margin: the component of an enumeration has this value
  std::uint32_t channel, component;
  std::int64_t value;
};
struct InputSame {  // a margin: two components of one enumeration agree
  std::uint32_t channel, component, other_channel, other_component;
};
struct Open {  // a margin: now is within an opening of the schedule
  ScheduleIndex schedule;
};
struct Elapsed {  // a margin: this many ticks have passed since the first one
  std::int64_t ticks;
};
struct Age {  // us since the stamp of the newest sample
  std::uint32_t channel;
};
enum class Sensed { position, velocity, battery };
struct SensedAge {  // of a fact: the same of what the robot itself senses
  Sensed signal;
};
struct ParamValue {
  std::uint32_t param;
};
struct Multiply {
  ValueId a, b;
};
struct Minimum {
  ValueId a, b;
};
struct Maximum {
  ValueId a, b;
};
struct Absolute {
  ValueId a;
};
struct Root {  // square root
  ValueId a;
};
struct PointClearance {  // signed distance of the place (a, b) from the boundary, in mm
  ValueId a, b;
  RegionIndex within, around;  // the zone, or what is certainly in it and what contains it
};
// The margin `condition` of a clearance that is at least 0; the place lies in the zone, boundary
// included, or outside: exactly, where a bound of its distance cannot tell.
struct PointInside {
  ValueId condition, a, b;
  RegionIndex within, around;
};
// The same of a place (a, b, c) and a zone with height.
struct SolidClearance {
  ValueId a, b, c;
  SolidIndex within, around;
};
struct SolidInside {
  ValueId condition, a, b, c;
  SolidIndex within, around;
};
// Places one after the other, and the straight legs between them: up to two of its own, then those
// of a path.
struct Trail {
  std::vector<ValueId> own;              // mm: x and y of the first place, of the second one
  std::optional<std::uint32_t> channel;  // behind places of its own what is left of it, else all
  bool next_only = false;                // the next way-point of it, none behind
};
// The least signed distance of its places from the boundary, or the greatest, in mm.
struct TrailClearance {
  Trail trail;
  RegionIndex within, around;
  bool greatest;
};
// The margin `condition` of that; every place lies in the zone or, `outside`, none does. A leg that
// crosses the boundary decides it, where bounds of distances cannot tell.
struct TrailInside {
  ValueId condition;
  Trail trail;
  RegionIndex within, around;
  bool outside;
};
struct TrailDistance {  // the least one between places of both, in mm
  Trail trail, other;
};
struct PathGiven {  // a margin: it has way-points
  std::uint32_t channel;
};
struct Norm {  // root of a^2 + b^2
  ValueId a, b;
};
struct Between {  // a constant that lies between two steps; open: strictly, and they are neighbours
  std::int64_t lo, hi;
  bool open = false;
};
// An angle in parts of a turn, 2^32 of them; a step of `a` is so many parts, in units of 2^-16.
struct Phase {
  ValueId a;
  std::int64_t least_q16, most_q16;
};
struct Sine {  // of a phase, in units of 2^-30
  ValueId a;
};
struct Cosine {
  ValueId a;
};
struct Choose {  // a if the margin is true, b if it is false, else the hull of both
  ValueId condition, a, b;
};
// Ticks [i - to, i - from]; to < 0: for ever. `full`: margins, else verdicts only.
struct Window {
  std::int64_t from, to;
  bool full;
};
struct Previously {
  ValueId a;
  std::uint32_t slot;  // of the watch's state
};
struct Once {
  ValueId a;
  Window window;
  std::uint32_t slot;
};
struct Historically {
  ValueId a;
  Window window;
  std::uint32_t slot;
};
struct Since {  // a since b
  ValueId a, b;
  Window window;
  std::uint32_t slot;
};
enum class Fold { minimum, maximum, mean, sum, count, rate };
struct Aggregate {  // a quantity, of a quantity or (count) of a margin
  Fold fold;
  ValueId a;
  Window window;
  std::uint32_t slot;
};

using Op =
    std::variant<Const, Battery, Clearance, Distance, EnergyTo, Speed, Add, Negate, Scale, AtLeast,
                 PlanInZone, Truth, Not, And, Or, HeldFor, ForOthers, CountOthers, ZoneReach,
                 LegsInZone, PointsInZone, PairReach, LegsApart, OnTrack, EnergyReach, ChargeReach,
                 SpeedReach, ZoneThere, ThereThroughout, GoneThroughout, Fact, Input, InputTruth,
                 InputIs, InputSame, Open, Elapsed, Age, SensedAge, ParamValue, Multiply, Minimum,
                 Maximum, Absolute, Root, PointClearance, PointInside, SolidClearance, SolidInside,
                 Norm, Between, Phase, Sine, Cosine, Choose, Previously, Once, Historically, Since,
                 Aggregate, ZoneCourse, PairCourse, Altitude, AltitudeReach, AgentDistance,
                 AgentReach, ReceivedClearance, ReceivedReach, ReceivedCourse, TrailClearance,
                 TrailInside, TrailDistance, PathGiven>;

struct Range {
  std::int64_t lo = 0, hi = 0;
  bool declared = true;  // every input behind it has a declared range
};
// The block of an operation that judges other robots one by one; nullptr: it has none.
inline Block* body_of(Op& op) {
  if (auto* others = std::get_if<ForOthers>(&op)) return others->body.get();
  auto* counted = std::get_if<CountOthers>(&op);
  return counted != nullptr ? counted->body.get() : nullptr;
}
inline const Block* body_of(const Op& op) {
  if (const auto* others = std::get_if<ForOthers>(&op)) return others->body.get();
  const auto* counted = std::get_if<CountOthers>(&op);
  return counted != nullptr ? counted->body.get() : nullptr;
}
struct Value {
  Op op;
  std::optional<Unit> unit;    // none: a margin
  std::optional<Range> range;  // of quantities; set by analyse_ranges
  SourceRange source;
  std::string text{};  // as written, on one line; of quantities of robots: none
};
struct Block {
  std::vector<Value> values;
  ValueId result{};
  [[nodiscard]] const Value& operator[](ValueId id) const {
    return values[static_cast<std::uint32_t>(id)];
  }
};

// ---- monitors without a robot, and what monitors of robots say that does not look ahead
// ----------

// Of a zone or a path, whether there is one.
enum class ChannelKind { truth, number, choice, zone, path };
inline const char* word(ChannelKind kind) {
  constexpr const char* words[] = {"truth", "number", "choice", "zone", "path"};
  return words[static_cast<std::size_t>(kind)];
}
struct ChannelGrid {  // of a number: what is possible on the grid, the error in steps
  Unit unit;
  Range range;  // outside: unknown
  std::int64_t error_steps = 0;
};
// A plain input; its components arrive together, each a scalar of this kind.
struct Channel : ChannelGrid {
  std::string name;
  std::uint32_t declared = 0;  // index in the specification
  ChannelKind kind = ChannelKind::number;
  std::vector<std::string> components;  // "" for a scalar; "x", "y"; "0", "1", ...
  std::string choice;                   // name of the enumeration of a choice, with its values
  std::vector<std::string> values;
  // Of poses and twists: that of the last of the `element_size` components of each.
  std::optional<ChannelGrid> turning;
  std::uint32_t element_size = 1;
  [[nodiscard]] const ChannelGrid& grid(std::uint32_t component) const {
    return turning && component % element_size + 1 == element_size ? *turning : *this;
  }
  std::optional<std::int64_t> max_age_us;  // none and not held: must arrive every tick
  bool held = false;
  std::uint32_t edges_most = 0;   // of a zone
  std::uint32_t places_most = 0;  // of a path: way-points
};
struct Param {
  std::string name;
  std::uint32_t declared = 0;  // index in the specification
  Unit unit;
  Range range;
  std::int64_t value = 0;
  int tightens = 0;  // the direction in which it may move at run time; 0: none
};
struct PlainMonitor {
  std::string name, requirement_id, requirement_text;
  std::string file;  // base name of the source file
  std::uint32_t line = 0;
  std::string text;  // of the property, on one line
  SourceRange source;
  Block property;
};
// The monitors of a specification that belong to no robot: judged together, every period.
struct Region {  // a zone that places are held against
  std::string name;
  bool around = false;  // contains the zone as written; else that contains it
  std::vector<Edge> edges;
  EdgeTree tree;
  // Of a zone that is received: the channel; its edges are not known yet. Both sides of it are one
  // region here.
  std::optional<std::uint32_t> channel = std::nullopt;
  std::uint32_t slab = 0;  // of a zone with height: which one from below, from 1 on
  // Of one that contains the zone: by how many mm distances from its boundary, and from that of the
  // one within the zone, may disagree; none: nothing bounds that.
  std::optional<std::int64_t> spread_mm = std::nullopt;
};
struct Slab {  // both ends belong to it
  std::int32_t floor_mm = 0, ceiling_mm = 0;
  RegionIndex region{};
};
struct Solid {  // a zone with height
  std::string name;
  bool around = false;      // as of regions
  std::vector<Slab> slabs;  // from below to above; their insides are apart
  std::optional<std::int64_t> spread_mm = std::nullopt;  // as of regions
};
struct Opening {  // from the first on, before the second
  std::int64_t from_us = 0, until_us = 0;
};
// When a zone is there: moments since 1970-01-01T00:00Z, and times of every week since its Monday
// 00:00Z. Each list is in order, and no two of it overlap or touch.
struct Schedule {
  std::string name;  // of the zone
  std::vector<Opening> once, weekly;
};
// A zone that is received, as monitors of robots ask for it: to stay within it, or outside of it.
struct Received {
  std::string name;
  std::uint32_t channel = 0;
  bool outside = false;
};
// Where (0 m, 0 m) of the map is on the globe.
struct Origin {
  double latitude_deg = 0, longitude_deg = 0;
};
struct Watch {
  std::int64_t period_us = 0;
  bool in_utc = false;  // the clock counts from 1970-01-01T00:00Z
  std::optional<Origin> origin;
  std::vector<Channel> inputs;
  std::vector<Param> params;
  std::vector<Region> regions;
  std::vector<Solid> solids;
  std::vector<Schedule> schedules;
  std::vector<Received> received;  // of a decision
  std::vector<PlainMonitor> monitors;
  std::uint32_t slots = 0;  // of the operators that remember
  // Units of margins; entry 0 stands for truth values, which have none.
  std::vector<Unit> units;
  [[nodiscard]] const Region& operator[](RegionIndex i) const {
    return regions[static_cast<std::uint32_t>(i)];
  }
  [[nodiscard]] const Solid& operator[](SolidIndex i) const {
    return solids[static_cast<std::uint32_t>(i)];
  }
  // By how much distances from both may disagree; none: nothing bounds that.
  [[nodiscard]] std::optional<std::int64_t> spread_mm(RegionIndex within,
                                                      RegionIndex around) const {
    if (within != around) return (*this)[around].spread_mm;
    return (*this)[within].channel ? std::nullopt : std::optional<std::int64_t>(0);
  }
  [[nodiscard]] std::optional<std::int64_t> spread_mm(SolidIndex within, SolidIndex around) const {
    return within != around ? (*this)[around].spread_mm : 0;
  }
  [[nodiscard]] const Schedule& operator[](ScheduleIndex i) const {
    return schedules[static_cast<std::uint32_t>(i)];
  }
  [[nodiscard]] const Received& operator[](ReceivedIndex i) const {
    return received[static_cast<std::uint32_t>(i)];
  }
};

// ---- decisions ----------------------------------------------------------------------------------

struct Lookahead {
  bool duration = true;          // false: way-points only
  std::int64_t duration_us = 0;  // D
  std::int64_t waypoints = 0;    // n, 0: the plan is not looked at
  bool points_only = false;
  bool too_short = false;   // for its recovery to act in time, as the author accepts
  std::int64_t gap_us = 0;  // longest time between two steps that it covers
  bool command = false;     // under the known commands, where that is less
};
// What moves by itself, rounded to the safe side.
struct Agent {
  std::string name;
  std::int64_t radius_mm = 0, error_mm = 0, speed_mmps = 0, age_us = 0;
  std::uint32_t seen = 0;                // channel of Decision::facts: x, y; in space z
  std::optional<std::uint32_t> present;  // channel: whether it is there at all
  bool in_space = false;
};
inline constexpr std::int64_t agent_far_mm = std::int64_t{1} << 31;  // beyond any distance
enum class RecoveryKind { external, retreat, route, yield, brake, loiter, sequence, land };
struct Recovery {
  std::string name;
  RecoveryKind kind = RecoveryKind::external;
  ZoneIndex zone{};
  SiteIndex site{};
  std::int64_t speed_mmps = 0;
  // Clearances of the centre (retreat, route, yield) and distance of centres (yield).
  std::int64_t route_clearance_mm = 0, return_clearance_mm = 0, pass_gap_mm = 0;
  bool claims = false;          // external: to stay inside `zone`, at most at `speed_mmps`
  std::int64_t lasts_us = 0;    // as a step of a sequence; 0: until control is given back
  std::vector<Recovery> steps;  // of a sequence
  // Of a monitor that speaks of zones that come and go: from taking over until the robot has left
  // them, or at least stands.
  std::int64_t leave_us = 0;
  // A route knows ways from wherever the body keeps so much from the boundary of its zone.
  std::int64_t leave_least_mm = 0;
  // What its first leg, to the centre of a cell, may lead nearer to what the property asks to keep
  // off; the look-ahead of the monitor asks for so much more.
  std::int64_t leave_beside_mm = 0;
  std::int64_t land_mm = 0;  // of a landing: how high the centre ends
  bool charges = false;      // a route: to the site at which its robot is charged
};
// Of a zone from whose boundary the centre keeps `asked_mm`: cells of the own one keep enough.
inline std::int64_t leave_beside_mm(const Recovery& r, ZoneIndex zone, std::int64_t asked_mm) {
  return zone == r.zone && asked_mm <= r.route_clearance_mm ? 0 : r.leave_beside_mm;
}
// It knows a zone and moves within it.
inline bool moves(RecoveryKind kind) {
  return kind == RecoveryKind::retreat || kind == RecoveryKind::route ||
         kind == RecoveryKind::yield || kind == RecoveryKind::loiter;
}
// It goes back into its zone, to where control is given back.
inline bool goes_back(RecoveryKind kind) {
  return kind == RecoveryKind::retreat || kind == RecoveryKind::loiter;
}
// The recovery, or the steps of a sequence.
inline std::vector<const Recovery*> steps_of(const Recovery& r) {
  if (r.kind != RecoveryKind::sequence) return {&r};
  std::vector<const Recovery*> all;
  for (const Recovery& step : r.steps) all.push_back(&step);
  return all;
}
// What it does in the end, until control is given back.
inline const Recovery& last_step(const Recovery& r) {
  return r.kind == RecoveryKind::sequence ? r.steps.back() : r;
}
// What becomes of a return condition where the recovery has led: it holds there, it is up to inputs
// alone, or neither is shown.
struct Returns {
  enum class How { itself, told, open };  // from the best to the worst
  How how = How::itself;
  std::int64_t after_us = 0;  // for how long it has to hold, at most
  // Where a robot is left by its recovery, and not given back.
  std::optional<std::pair<std::int64_t, std::int64_t>> stuck_mm{};
  // It asks for less than this speed, at which every sample shows a robot at rest to be.
  std::optional<std::int64_t> shown_mmps{};
  // It asks for a lower place than this one, below which every sample shows a robot that has
  // landed; and for a lower one than where it lands.
  std::optional<std::int64_t> shown_high_mm{};
  bool lands_above = false;
};
struct Monitor {
  std::string name, requirement_id, requirement_text;
  std::string file;  // base name of the source file
  std::uint32_t line = 0;
  std::string text;          // of the property, on one line
  std::string return_text;   // the same of the return condition
  std::optional<Unit> unit;  // of the reported margin; none: that of the atom that decides
  Lookahead lookahead;
  SourceRange source, lookahead_source;
  Block property;
  std::optional<Block> ahead;        // made by expand_lookahead
  std::optional<Block> return_when;  // none: only the derived condition
  Returns returns;
  Recovery recovery;
  // Largest standoff that a separation atom of the property asks for; none: no such atom.
  std::optional<std::int64_t> separation_mm;
  // Why it is accepted that the recovery does not lead out of a violation; "": it does.
  std::string hold_reason;
};
struct Acknowledgement {
  std::string recovery, monitor, reason;
};
// Whether a recovery keeps a property: it is not shown, it is, or the property is that of its
// monitor.
enum class Kept { unproved, proved, own };
struct Decision {
  std::string name, kind, advanced, safe;
  bool on_plan = false;
  std::int64_t period_us = 0, return_extra_us = 0, dwell_ticks = 0, lease_us = 0;
  std::uint32_t robots = 1;  // size of the fleet of this kind
  bool open_fleet = false;   // messages say whether their sender is present
  std::int64_t plan_capacity = 0;
  Body body;
  // By how much what pushes it makes a recovery faster or slower than it means to be.
  std::int64_t pushed_mmps = 0;
  // Clearance of the centre at which a robot at full speed never fails a fence: for planners.
  std::int64_t cruise_clearance_mm = 0;
  std::int64_t hold_reserve_ppm = 0;  // charge that held time and detours may take
  // How much a robot that stands when it is armed needs to spare to be kept where it is.
  std::int64_t standing_mm = 0;
  std::vector<Motion> motions;    // 0: any control, k + 1: recovery of monitor k
  std::vector<Monitor> monitors;  // by priority
  std::uint32_t held_slots = 0;
  std::vector<Acknowledgement> acknowledgements;
  // What its monitors say of plain inputs and of the past, which is judged now whatever the
  // look-ahead: with the inputs and parameters that they use, each fact like a monitor without a
  // robot. A fact of a return condition may speak of the robot. Of the units, 1 is that of lengths,
  // 2 that of charge and 3 that of numbers of robots.
  // Its schedules are those of the zones that the monitors hold robots against, too.
  Watch facts;
  // How many commands are kept: as many as may act after a sample was taken, and one before. The
  // same for all decisions that judge commands, else 0.
  std::int64_t commands = 0;
  // What another robot may cover, body included, seen from where it was heard: the most for every
  // horizon, speed and age.
  std::int64_t heard_reach_mm = 0;
  std::vector<Agent> agents;  // that its monitors speak of
  [[nodiscard]] const Agent& operator[](AgentIndex i) const {
    return agents[static_cast<std::uint32_t>(i)];
  }
  // `coordinate`: of the recoveries of engaged monitors the one drives that keeps the longest
  // prefix of the order. A row says what is proved of the recovery of a monitor, a column of which
  // property.
  bool coordinated = false;
  std::vector<std::vector<Kept>> keeps{};
};
// From a decision until its recovery acts, the age of the sample apart.
inline std::int64_t horizon_us(const Decision& d, const Monitor& m) {
  return m.lookahead.duration_us + d.body.latency_us + d.body.jitter_us;
}
// From a decision until the next one acts, jitter included, at most, while an external recovery
// drives: its claim is checked under what the robot can do in that time.
inline std::int64_t reaction_us(const Decision& d, const Recovery& external) {
  std::int64_t most_us = 0;
  for (const Monitor& m : d.monitors) {
    if (m.recovery.name == external.name) most_us = std::max(most_us, horizon_us(d, m));
  }
  return most_us;
}
// The mode that the robot takes when the advanced side gives control up by itself: a recovery that
// makes way for others if there is one, else that of the highest priority.
inline std::int64_t surrender_mode(const Decision& d) {
  for (std::size_t k = 0; k < d.monitors.size(); ++k) {
    if (d.monitors[k].recovery.kind == RecoveryKind::yield) return std::int64_t(k) + 1;
  }
  return 1;
}

struct Module {
  std::string name;
  std::vector<ZoneTable> zones;
  std::vector<SiteTable> sites;
  std::vector<Decision> decisions;
  std::optional<Watch> watch;
  [[nodiscard]] const ZoneTable& operator[](ZoneIndex i) const {
    return zones[static_cast<std::uint32_t>(i)];
  }
  [[nodiscard]] const SiteTable& operator[](SiteIndex i) const {
    return sites[static_cast<std::uint32_t>(i)];
  }
};

// Does some monitor look ahead under commands?
inline bool judges_commands(const Decision& d) {
  for (const Monitor& m : d.monitors) {
    if (m.lookahead.command) return true;
  }
  return false;
}
// Does some robot move up and down as well?
inline bool in_space(const Module& module) {
  for (const Decision& d : module.decisions) {
    if (d.body.in_space) return true;
  }
  return false;
}
// Is some robot pushed by what nobody commands?
inline bool is_disturbed(const Module& module) {
  for (const Decision& d : module.decisions) {
    if (d.body.disturbance_mmps2 > 0) return true;
  }
  return false;
}
// Does some brake bend by half of what the sampled brake loses?
inline bool is_calm(const Module& module) {
  for (const Decision& d : module.decisions) {
    if (d.body.brake_lag_ms < d.body.brake_late_ms) return true;
  }
  return false;
}
// Does some decision look out for what moves by itself?
inline bool has_agents_in_space(const Module& module) {
  for (const Decision& d : module.decisions) {
    for (const Agent& agent : d.agents) {
      if (agent.in_space) return true;
    }
  }
  return false;
}
inline bool has_agents(const Module& module) {
  for (const Decision& d : module.decisions) {
    if (!d.agents.empty()) return true;
  }
  return false;
}
// Does some decision hear whether other robots are present?
inline bool has_open_fleet(const Module& module) {
  for (const Decision& d : module.decisions) {
    if (d.open_fleet) return true;
  }
  return false;
}

}  // namespace rtac::ir
