// The checked specification: names resolved, types and units checked, every quantity an exact
// rational in SI units (m, s, rad, m/s, ...; a ratio of 1 is 100 %). Later phases trust it.
// Each entry keeps the range of its source text, so that every later message can point to it.
#pragma once

#include <array>
#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/support/rational.h"
#include "compiler/support/source.h"

namespace rtac::sema {

enum class ZoneId : std::uint32_t {};
enum class KindId : std::uint32_t {};   // a kind of robot
enum class RobotId : std::uint32_t {};  // a member of a fleet
enum class SiteId : std::uint32_t {};   // a family of places: dock, home
enum class ControllerId : std::uint32_t {};
enum class MonitorId : std::uint32_t {};
enum class DecisionId : std::uint32_t {};
enum class InputId : std::uint32_t {};  // a plain input signal
enum class ParamId : std::uint32_t {};
enum class EnumId : std::uint32_t {};
enum class FrameId : std::uint32_t {};  // a frame of coordinates
enum class AgentId : std::uint32_t {};  // what moves by itself and obeys no decision

// A literal or derived quantity with the place it came from.
struct Quantity {
  Rational value;  // SI
  SourceRange range;
};

// Exponents of the base units. `ratio` is a base of its own: 5 % is not 0.05 of a bare number.
struct Dimension {
  int m = 0, s = 0, kg = 0, rad = 0, ratio = 0, A = 0, K = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

struct Point {
  Rational x, y;  // m, in the frame of the zone; sites: map
};

// A frame of coordinates. How frames lie to each other is measured: a pose.
struct Frame {
  std::string name;
  SourceRange name_range;  // of `map`: empty
};
inline constexpr FrameId map_frame{0};  // there always is; robots live in it

// Where (0 m, 0 m) of `map` is, x to the east and y to the north: the azimuthal equidistant
// projection of the WGS 84 ellipsoid.
struct Origin {
  Quantity latitude, longitude;      // rad, as the unit `deg` has it
  std::optional<Quantity> altitude;  // m above mean sea level
};

// ---- zones ------------------------------------------------------------------------------------

struct ZoneExpr;
using ZoneExprPtr = std::unique_ptr<ZoneExpr>;

struct ZonePolygon {  // a rectangle is a polygon with four corners
  // What a message about a ring of another file tells of its vertices.
  struct InFile {
    std::string where;                    // the file and the place in it
    std::vector<std::uint32_t> vertices;  // of each point; long edges have points between vertices
    std::vector<std::array<double, 2>> positions;  // of each vertex: latitude, longitude; or x, y
  };
  struct Ring {
    std::vector<Point> points;
    std::vector<SourceRange> point_ranges;  // of an imported ring: none
    SourceRange range;
    std::optional<InFile> in_file = std::nullopt;
  };
  Ring outer;
  std::vector<Ring> holes;
};
struct ZoneCircle {
  Point centre;
  Rational radius;
};
struct ZoneRef {
  ZoneId zone;
};
enum class ZoneOp { unite, intersect, subtract };
struct ZoneBinary {
  ZoneOp op;
  ZoneExprPtr left, right;
};
struct ZoneOffset {  // grow when positive, shrink when negative
  ZoneExprPtr operand;
  Rational distance;
};
// From one moment on, before another: once, or on certain days of every week. In UTC.
struct Opening {
  std::uint8_t days = 0;                 // bit 0: Monday, ...; 0: once
  std::int64_t from_s = 0, until_s = 0;  // since 1970-01-01T00:00Z; of days: since their midnight
  auto operator<=>(const Opening&) const = default;
};
// Ends of windows that have none: as far as the clock counts microseconds, 292,000 years away.
inline constexpr std::int64_t for_ever_s = 9'223'372'036'854, since_ever_s = -for_ever_s;
// The areas of a file: inside any of the inclusions, which is inside all of its areas, and outside
// of every exclusion.
struct ZoneImport {
  struct Band {  // m; without an end: from the lowest place there is, or to the highest
    std::optional<Rational> floor, ceiling;
  };
  struct Area {  // the union of its parts
    std::vector<std::variant<ZonePolygon, ZoneCircle>> parts;
    std::vector<Band> bands;  // of each part of a zone with height; else none
  };
  std::string path;  // as written
  std::vector<std::vector<Area>> inclusions;
  std::vector<Area> exclusions;
  Rational error;                        // m: boundary and distances are off by at most this much
  bool degrees = false;                  // it was projected
  std::size_t vertices = 0, points = 0;  // in the file; with those within long edges
  Rational farthest;                     // m, rounded up: from (0 m, 0 m)
  std::vector<std::string> remarks;      // what is left out, with the author's reasons
  std::vector<Opening> openings{};       // when its areas apply, of an import `scheduled`
};
struct ZoneReceived {  // while the monitors run
  InputId input;
  std::uint32_t edges_most;
};
struct ZonePrism {  // of a zone of the plane; floor < ceiling
  ZoneExprPtr base;
  Rational floor, ceiling;  // m
};
struct ZoneComplement {  // every place that is not in the zone
  ZoneId zone;
};
struct ZoneExpr {
  SourceRange range;
  std::variant<ZonePolygon, ZoneCircle, ZoneRef, ZoneBinary, ZoneOffset, ZoneImport, ZonePrism,
               ZoneReceived, ZoneComplement>
      node;
};
struct Zone {
  std::string name;  // empty: written inside a property (shrink(free, 15 cm)); named by its place
  SourceRange name_range;
  ZoneExprPtr value;
  FrameId frame = map_frame;
  bool has_height = false;          // else it lies in the plane
  std::vector<Opening> openings{};  // outside of them it is empty; none: it is always there
};

// ---- robots -----------------------------------------------------------------------------------

enum class MotionModel { point, unicycle };
struct Motion {
  MotionModel model;
  SourceRange range;
  Quantity speed, accel, brake;
  std::optional<Quantity> turn, turn_accel;  // unicycle only; turn_accel may be left out
  std::optional<Quantity> disturbance{};     // point only: acceleration that nobody commands
};
struct Sense {
  Quantity error, max_age;
};
struct PlanInput {
  int capacity;  // way-points
  Quantity tracking;
  SourceRange range;
};
enum class OutputType { twist, acceleration };
struct Energy {
  SourceRange range;
  Quantity drive;   // ratio/m
  Quantity idle;    // ratio/s, at rest
  Quantity drain;   // ratio/s, the most that any motion takes
  Quantity charge;  // ratio/s, at the site `charge_at`
  SiteId charge_at;
  Quantity held;    // s: longest total time that other recoveries hold the robot on its way
  Quantity detour;  // m: longest way that other recoveries move it off its path
};
struct RobotKind {
  std::string name;
  SourceRange name_range;
  Quantity radius;
  Motion motion;
  std::optional<Sense> position, heading, velocity, battery;
  std::optional<Quantity> hears_max_age;
  bool open_fleet = false;  // messages say whether their sender is present
  std::optional<PlanInput> plan;
  std::string output_name;
  OutputType output;
  Quantity latency;
  std::optional<Energy> energy;
  std::optional<Quantity> output_error{};  // between commanded and true acceleration, m/s^2
  bool in_space = false;                   // position and velocity have three components
};
// Acceleration that nobody commands, in m/s^2: what pushes the robot, and what its output errs.
inline Rational disturbance_of(const RobotKind& kind) {
  Rational push = kind.motion.disturbance ? kind.motion.disturbance->value : Rational(0);
  if (kind.output_error) push += kind.output_error->value;
  return push;
}
struct Robot {
  std::string name;  // "r1", "bots[3]"
  SourceRange name_range;
  KindId kind;
  std::optional<std::uint32_t> number = std::nullopt;  // in a numbered fleet
  std::string fleet{};                                 // the name of that fleet
};
// A person, a forklift: a disc that moves as it likes, up to a speed. Whoever runs a decision tells
// it where the agent is, by the inputs that stand for it.
struct Agent {
  std::string name;  // "worker", "people[3]"
  SourceRange name_range;
  Quantity radius, speed;            // m, m/s
  Sense position;                    // m
  InputId seen{};                    // x, y; in space z
  std::optional<InputId> present{};  // whether it is there at all
  std::string group{};               // the name of numbered ones
  bool in_space = false;             // its position has a height
};
struct Site {
  std::string name;
  struct Place {
    std::optional<RobotId> robot;  // none: the same place for every robot
    Point position;
    SourceRange range;
  };
  std::vector<Place> places;
};

// ---- controllers ------------------------------------------------------------------------------

struct ExternController {
  // What its author claims: a robot that it drives stays inside the zone, at most this fast.
  struct Claim {
    ZoneId zone;
    Quantity speed;
  };
  std::optional<Claim> claim;
};
struct Retreat {
  ZoneId zone;
  Quantity speed;
};
struct Route {
  SiteId site;
  ZoneId zone;
  Quantity speed;
};
struct Yield {
  ZoneId zone;
  Quantity speed;
};
struct BrakeAndHold {};
struct Loiter {
  ZoneId zone;
  Quantity speed;
};
struct Land {  // straight down, in space
  Quantity height, speed;
};
using Template = std::variant<Retreat, Route, Yield, BrakeAndHold, Loiter, Land>;
struct Sequence {
  struct Step {
    Template what;
    std::optional<Quantity> lasts;  // none: the last step, until control is given back
  };
  std::vector<Step> steps;
};
struct Controller {
  std::string name;
  SourceRange name_range;
  bool advanced;
  KindId kind;
  std::variant<ExternController, Retreat, Route, Yield, BrakeAndHold, Loiter, Sequence, Land>
      implementation;
};

// ---- inputs and parameters of monitors without a robot ------------------------------------------

struct Enumeration {
  std::string name;
  SourceRange name_range;
  std::vector<std::string> values;
};
// A zone is none of the numbers, only whether one is there; nor is a path, but for its index.
enum class InputType { boolean, integer, real, enumeration, zone, path };
// What is declared of one number of an input, of integer and real.
struct Measurement {
  Dimension dimension;                  // of integer: none
  std::optional<Quantity> least, most;  // SI: a value outside is unknown
  Rational resolution = 1;        // SI, grid of the kernel: 1/1000 for m, m/s, rad; 1e-6 ratio
  std::optional<Quantity> error;  // SI; none: exact
};
// A plain input. Points and vectors are components `x`, `y` and in space `z`; a pose is `x`, `y`,
// `heading`, a twist `linear`, `angular`; arrays are their elements: a component is a scalar of
// `type`, all of one input arrive together with one stamp.
struct Input : Measurement {
  std::string name;
  SourceRange name_range;
  InputType type;
  std::optional<EnumId> enumeration;    // of an enumeration
  std::vector<std::string> components;  // "" for a scalar; "x", "y"; "0", "1", ...; "0.x", ...
  // The last component of each pose or twist is measured in another way than the others.
  std::optional<Measurement> turning;
  std::uint32_t element_size = 1;  // components of one element of an array, or of all
  std::uint32_t edges_most = 0;    // of a zone
  std::uint32_t places_most = 0;   // of a path: way-points
  [[nodiscard]] const Measurement& measurement(std::uint32_t component) const {
    return turning && component % element_size + 1 == element_size ? *turning : *this;
  }
  std::optional<Quantity> max_age;  // none and not `held`: a new sample every tick
  bool held = false;                // max_age inf: the last value holds for ever
  std::optional<RobotId> robot;     // it is what this robot senses, not declared as an input
  std::optional<AgentId> agent{};   // it is what is seen of this agent
};
struct Param {
  std::string name;
  SourceRange name_range;
  Dimension dimension;
  Rational resolution = 1;
  Quantity least, most, value;
  // In which direction it may move at run time: +1 up, -1 down, 0 not at all (no monitor uses it).
  int tightens = 0;
};
struct Assumption {
  std::string text;  // as written
  SourceRange range;
  std::string checked_by;  // empty: unchecked
  std::string reason;      // of an unchecked one
};
// Margins of one dimension are compared in units of this many SI units (default: 1; 1 % of ratios).
struct MarginScale {
  Dimension dimension;
  Quantity value;
};

// `grid`: the resolution of inputs and parameters of this dimension that name none of their own.
struct GridStep {
  Dimension dimension;
  Quantity value;
};

// ---- properties -------------------------------------------------------------------------------

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

enum class Subject { self, other };  // the monitored robot, or the bound variable of `forall`
enum class Signal { battery, speed, altitude };     // altitude: of the centre, position.z
enum class Sensed { position, velocity, battery };  // what has a stamp

struct Constant {
  Rational value;
  bool declared = false;  // the size of a body: not written in the property, so on any grid
};
struct Truth {
  bool value;
};
struct SignalRef {  // r.battery, r.speed, r.position.z
  Subject subject;
  Signal signal;
};
struct Clearance {  // clearance(r, Z): gap between the body and the boundary, negative outside
  ZoneId zone;
};
struct Distance {};     // distance(r, q): gap between the two bodies, negative on overlap
struct AgentDistance {  // distance(r, worker): the same to an agent; infinite while that is absent
  AgentId agent;
  InputId seen;  // those of the agent
  std::optional<InputId> present;
};
struct EnergyTo {  // energy_to(dock(r)): upper bound of the charge that the way there takes
  SiteId site;
};
struct InsideZone {  // r inside Z
  ZoneId zone;
};
struct PlanInside {  // r.plan inside Z: every way-point and every leg of the plan
  ZoneId zone;
};
enum class ArithmeticOp { add, subtract, multiply, divide, negate };
struct Arithmetic {
  ArithmeticOp op;
  std::vector<ExprPtr> operands;
};
enum class CompareOp { less, less_equal, greater, greater_equal };
struct Compare {
  CompareOp op;
  ExprPtr left, right;
};
enum class LogicOp { logical_not, logical_and, logical_or, implies, iff, logical_xor };
struct Logic {
  LogicOp op;
  std::vector<ExprPtr> operands;
};
struct HeldFor {
  ExprPtr operand;
  Quantity duration;
};
struct ForOthers {  // forall / exists q : Kind, q != r
  bool universal;
  ExprPtr body;
};
struct CountOthers {  // count(q : Kind, q != r : φ)
  ExprPtr body;
};
// min or max over members of a fleet; comparisons of it are those of its members, so that a checked
// property has none.
struct OverMembers {
  bool maximum;
  std::vector<ExprPtr> operands;  // of a monitor of a robot: one, for every other robot
};
struct InputRef {  // one component of a plain input
  InputId input;
  std::uint32_t component;
};
struct AgeOf {  // age(signal), in s
  InputId input;
};
struct SensedAge {  // age(r.position) of the monitored robot, in s; judged now
  Sensed signal;
};
struct ParamRef {
  ParamId param;
};
struct PointInside {  // p inside Z
  ExprPtr x, y;       // m
  ExprPtr z;          // m, of a zone with height; else null
  ZoneId zone;
};
struct PointClearance {  // clearance(p, Z): distance to the boundary, negative outside
  ExprPtr x, y;          // m
  ExprPtr z;             // m, of a zone with height; else null
  ZoneId zone;
};
struct ZoneOpen {  // now is within an opening of the zone
  ZoneId zone;
};
// Places one after the other, and the straight legs between them: up to two of its own, then those
// of a path. In the plane.
struct Trail {
  std::vector<ExprPtr> own;     // m: x and y of the first place, of the second one
  std::optional<InputId> path;  // behind places of its own what is left of it, else all of it
  bool next_only = false;       // the next way-point of it, none behind
};
struct TrailInside {  // every place of it lies in the zone or, `outside`, none does
  Trail trail;
  ZoneId zone;
  bool outside;
};
struct TrailClearance {  // the least distance to the boundary, negative outside; or the greatest
  Trail trail;
  ZoneId zone;
  bool greatest;
};
struct TrailDistance {  // the least one between places of both
  Trail trail, other;
};
struct ZoneDistance {  // the least one between places of both, which stay as they are
  ZoneId zone, other;
};
struct PathGiven {  // it has way-points
  InputId input;
};
// A distance from a zone while that is open, or of a path while it has way-points; else more than
// any other (`endless`), or less. The comparison that it stands in takes it apart, so that a
// checked property has none.
struct WhileOpen {
  std::variant<ZoneId, InputId> what;
  bool endless;
  ExprPtr operand;
};
struct IsValue {  // mode == drive, for a component of an enumeration
  InputId input;
  std::uint32_t component;
  std::uint32_t value;  // index into Enumeration::values
};
struct SameValue {  // two components of the same enumeration
  InputRef left, right;
};
// norm: of its components; sine and cosine: of an angle, a bare number
enum class MathOp { minimum, maximum, absolute, square_root, norm, sine, cosine };
struct Math {
  MathOp op;
  std::vector<ExprPtr> operands;
};
struct Choice {  // if c then a else b, of quantities; of conditions it is written with and, or, not
  ExprPtr condition, then_value, else_value;
};
// [a, b] in the past; exact multiples of the period. No `to`: for ever.
struct Interval {
  Quantity from;
  std::optional<Quantity> to;
};
struct Previously {
  ExprPtr operand;
};
enum class PastOp { once, historically };
struct Past {
  PastOp op;
  Interval interval;
  ExprPtr operand;
};
struct Since {
  Interval interval;
  ExprPtr left, right;
};
struct WithinOf {  // φ within d of ψ
  ExprPtr operand, trigger;
  Quantity duration;
};
enum class AggregateOp { minimum, maximum, mean, sum, count, rate };
struct Aggregate {  // a quantity; the operand of `count` is a condition
  AggregateOp op;
  Interval interval;
  ExprPtr operand;
};
struct Expr {
  SourceRange range;
  bool boolean;  // else a quantity of `dimension`
  Dimension dimension;
  std::variant<Constant, Truth, SignalRef, Clearance, Distance, EnergyTo, InsideZone, PlanInside,
               Arithmetic, Compare, Logic, HeldFor, ForOthers, CountOthers, OverMembers, InputRef,
               AgeOf, SensedAge, ParamRef, PointInside, PointClearance, ZoneOpen, WhileOpen,
               TrailInside, TrailClearance, TrailDistance, ZoneDistance, PathGiven, IsValue,
               SameValue, Math, Choice, Previously, Past, Since, WithinOf, Aggregate, AgentDistance>
      node;
};

// A monitor without a robot: judged every period, no decision follows from it.
struct Watch {
  std::string name;
  SourceRange name_range, range;
  std::string requirement_id, requirement_text;
  ExprPtr always;
  SourceRange always_range;
  bool margin_full = false;  // margins of windows of any length
};

// ---- monitors and decisions -------------------------------------------------------------------

struct Ahead {
  std::optional<Quantity> duration;  // none and not waypoints_only: derived from the period
  std::optional<std::string> duration_unsound;
  int waypoints = 0;  // 0: the plan is not looked at
  bool waypoints_only = false, points_only = false;
  std::string unsound_reason;  // of waypoints_only / points_only
  SourceRange range;           // of the clause, or of the monitor's name when there is none
  bool command = false;        // under the commands that are known, where that is less
};
struct Monitor {
  std::string name;
  SourceRange name_range, range;
  std::string robot;  // as the property calls it
  KindId kind;
  std::string requirement_id;    // "SR-3", the part before the first colon; may be empty
  std::string requirement_text;  // the rest
  ExprPtr always;
  SourceRange always_range;
  Ahead ahead;
  std::optional<ControllerId> recover;
  SourceRange recover_range;
  ExprPtr return_when;  // may be null
  // Why it is accepted that the recovery does not lead out of a violation.
  std::optional<std::string> hold_reason;
  std::optional<SourceRange> hold_range;
};
struct Acknowledgement {
  ControllerId recovery;
  MonitorId monitor;
  std::string reason;
  SourceRange range;
};
struct Decision {
  std::string name;
  SourceRange name_range;
  KindId kind;
  ControllerId advanced;
  std::optional<ControllerId> safe;  // only with `on plan`
  bool on_plan = false;
  std::optional<Quantity> period;   // absent with `on plan`
  std::vector<MonitorId> priority;  // highest first
  std::vector<Acknowledgement> acknowledgements;
  std::optional<Quantity> jitter{};  // a step comes so much later than due; none: derived
  // Of several recoveries the one drives that keeps the longest prefix of the order (rule 12.1).
  bool coordinated = false;
  SourceRange order_range{};  // where the order begins
};

struct Spec {
  std::string name;
  SourceRange name_range;
  std::vector<Frame> frames{{"map", {}}};
  std::optional<Origin> origin;  // of the map
  std::vector<Zone> zones;
  std::vector<RobotKind> kinds;
  std::vector<Robot> robots;  // in the order of the fleets
  std::vector<Site> sites;
  std::vector<Controller> controllers;
  std::vector<Monitor> monitors;
  std::vector<Decision> decisions;
  // ---- of monitors without a robot
  std::optional<Quantity> period;
  std::optional<SourceRange> utc_clock;  // stamps and steps count from 1970-01-01T00:00Z
  std::vector<Enumeration> enumerations;
  std::vector<Input> inputs;
  std::vector<Param> params;
  std::vector<Assumption> assumptions;
  std::vector<MarginScale> scales;
  std::vector<GridStep> grids;
  std::vector<Watch> watches;
  std::vector<Agent> agents;

  template <class Id, class T>
  static const T& at(const std::vector<T>& items, Id id) {
    return items[static_cast<std::uint32_t>(id)];
  }
  const Frame& operator[](FrameId id) const { return at(frames, id); }
  const Zone& operator[](ZoneId id) const { return at(zones, id); }
  const RobotKind& operator[](KindId id) const { return at(kinds, id); }
  const Robot& operator[](RobotId id) const { return at(robots, id); }
  const Site& operator[](SiteId id) const { return at(sites, id); }
  const Controller& operator[](ControllerId id) const { return at(controllers, id); }
  const Monitor& operator[](MonitorId id) const { return at(monitors, id); }
  const Decision& operator[](DecisionId id) const { return at(decisions, id); }
  const Input& operator[](InputId id) const { return at(inputs, id); }
  const Param& operator[](ParamId id) const { return at(params, id); }
  const Agent& operator[](AgentId id) const { return at(agents, id); }
  const Enumeration& operator[](EnumId id) const { return at(enumerations, id); }
};

}  // namespace rtac::sema
