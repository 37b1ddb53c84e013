// The decision record: one per tick, plain data. Strings are static tables of the generated
// module, reached through `info`.
#pragma once

#include <array>
#include <cstdint>

#include "rtac/types.h"

namespace rtac {

enum class Verdict : std::int8_t { is_false = 0, is_unknown = 1, is_true = 2 };

enum class Reason : std::int8_t {
  none,           // the advanced controller drives and every check passed
  margin,         // the duration check of the look-ahead failed
  waypoint,       // way-point `reason_index` of the plan failed
  leg,            // leg `reason_index` of the plan failed (0: from here to the next way-point)
  violated,       // the property is false now
  within_error,   // the verdict is undecided within the declared errors
  input,          // a needed input is missing, stale, not finite or out of range
  returning,      // the recovery goes on until its return condition holds
  starting,       // no return condition was established yet since the start
  over_capacity,  // a plan is longer than the declared capacity
  surrendered,    // the advanced side gave control up by itself (it waits, or it is parked)
  tracking,       // the robot is further off its plan than the declared `tracking`
  claim           // an external recovery does not keep what it claims: it is braked
};

// Which input failed, for Reason::input. Numbers beyond those named here are of the plain inputs of
// the decision: first_plain_input + index in DecisionInfo::inputs.
enum class InputField : std::int32_t {
  none,
  position,
  velocity,
  heading,
  battery,
  plan,
  other_robot,
  clock
};
inline constexpr int first_plain_input = static_cast<int>(InputField::clock) + 1;

// What the separation test allows a moving safe controller to do.
enum class Gate : std::int8_t {
  free,       // the test holds for the active controller's own motion
  away_only,  // it fails only against robots that are HELD: move if no distance to them shrinks
  hold        // brake and hold
};

// Of a margin; none: nothing that has a unit decides (an input is missing). Numbers beyond those
// named here are of plain inputs: an index in DecisionInfo::units.
enum class MarginUnit : std::int8_t { none, metre, percent, count };
// A unit, and how many of it a margin of 1 is (the `scale` of the specification).
struct UnitInfo {
  const char* name;
  double scale;
};

struct MonitorInfo {
  const char* name;
  const char* requirement_id;
  const char* requirement_text;
  const char* source_file;
  int source_line;
  const char* recovery;          // name of the safe controller
  const char* return_condition;  // as written, or "" when only the derived one applies
  const char* unit;              // of the margin: "m", "%"; "": see MonitorRecord::unit
};
struct DecisionInfo {
  const char* decision;
  const char* kind;
  const char* advanced;
  const char* safe;  // of a decision on a plan, else ""
  const MonitorInfo* monitors;
  int monitor_count;
  TimeUs period_us;                     // 0: on plan
  const RobotLimits* limits = nullptr;  // age limits for the text of a reason; may be null
  const char* const* robots = nullptr;  // names of the robots of this kind; may be null
  int robot_count = 0;
  int surrender_mode = 1;  // whose recovery drives when the advanced side gives control up
  // Of plain inputs that its monitors speak of: names, and units of margins by MarginUnit.
  const char* const* inputs = nullptr;
  int input_count = 0;
  const UnitInfo* units = nullptr;
  int unit_count = 0;
  bool judges_commands = false;  // Observation::sent and ::proposed are asked for
};

struct MonitorRecord {
  Verdict now = Verdict::is_unknown;    // the property
  Verdict ahead = Verdict::is_unknown;  // the look-ahead under the active controller's motion
  Verdict safer = Verdict::is_unknown;  // the derived return condition
  bool engaged = false;
  double margin = 0;  // lower end of the look-ahead margin; -inf when unknown
  // Of the atom that decides, when the property mixes units; else MonitorInfo::unit is that of all.
  MarginUnit unit = MarginUnit::none;
};

struct DecisionRecord {
  const DecisionInfo* info = nullptr;
  std::uint64_t tick = 0;
  TimeUs time_us = 0;
  int robot = 0;
  // 0: advanced controller; k > 0: the recovery of monitor k - 1 (on a plan: 1 = `safe`).
  int mode = 0, previous_mode = 0;
  int deciding_monitor = -1;  // index, -1 when the advanced controller drives undisputed
  Reason reason = Reason::none;
  int reason_index = 0;
  InputField reason_input = InputField::none;
  int reason_other = -1;  // robot that the reason is about, -1: none
  Gate gate = Gate::free;
  TimeUs lease_end_us = never_us;  // HELD lease to announce
  // A lower bound: no property of lengths (clearance, distance) can be violated sooner, whoever
  // drives, as long as no robot exceeds its declared speed: spare length / fastest closing speed.
  // 0: one may be violated now. -1: unknown (a missing input, or no such property). Charge is left
  // out: what it has to suffice for jumps with the way.
  TimeUs time_to_violation_us = -1;
  TimeUs position_age_us = -1, velocity_age_us = -1, heading_age_us = -1, battery_age_us = -1;
  std::int64_t decision_ns = 0;  // filled by the caller that measures, else 0
  std::array<MonitorRecord, max_monitors> monitors{};
  [[nodiscard]] bool advanced() const { return mode == 0; }
};

// One generated decision for one robot, as the runtime sees it.
class DecisionModule {
 public:
  virtual ~DecisionModule() = default;
  [[nodiscard]] virtual const DecisionInfo& info() const = 0;
  // `holding`: the active safe controller has latched its position hold and means to stay there.
  // `surrender`: the advanced side gives control up; the recovery of DecisionInfo::surrender_mode
  // holds the robot.
  // Bounded time, no allocation, any input; the record stays valid until the next step.
  virtual const DecisionRecord& step(const Observation& observation, bool holding,
                                     bool surrender) = 0;
  // Starts anew. A promise to stay (lease) that was given binds until its end all the same.
  virtual void reset() = 0;
};

// A decision that runs when a plan is proposed (`on plan`).
class PlanDecision {
 public:
  virtual ~PlanDecision() = default;
  [[nodiscard]] virtual const DecisionInfo& info() const = 0;
  virtual const DecisionRecord& judge(const Path& plan, TimeUs now_us) = 0;
};

}  // namespace rtac
