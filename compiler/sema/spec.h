// The checked specification: names resolved, types and units checked, every quantity an exact
// rational in SI units (m, s, rad, m/s, ...; a ratio of 1 is 100 %). Later phases trust it.
// Each entry keeps the range of its source text, so that every later message can point to it.
#pragma once

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
  Rational x, y;  // m, map frame
};

// ---- zones ------------------------------------------------------------------------------------

struct ZoneExpr;
using ZoneExprPtr = std::unique_ptr<ZoneExpr>;

struct ZonePolygon {  // a rectangle is a polygon with four corners
  struct Ring {
    std::vector<Point> points;
    std::vector<SourceRange> point_ranges;
    SourceRange range;
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
struct ZoneExpr {
  SourceRange range;
  std::variant<ZonePolygon, ZoneCircle, ZoneRef, ZoneBinary, ZoneOffset> node;
};
struct Zone {
  std::string name;  // empty: written inside a property (shrink(free, 15 cm)); named by its place
  SourceRange name_range;
  ZoneExprPtr value;
};

// ---- robots -----------------------------------------------------------------------------------

enum class MotionModel { point, unicycle };
struct Motion {
  MotionModel model;
  SourceRange range;
  Quantity speed, accel, brake;
  std::optional<Quantity> turn, turn_accel;  // unicycle only; turn_accel may be left out
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
  std::optional<PlanInput> plan;
  std::string output_name;
  OutputType output;
  Quantity latency;
  std::optional<Energy> energy;
};
struct Robot {
  std::string name;
  SourceRange name_range;
  KindId kind;
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

struct ExternController {};
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
struct Controller {
  std::string name;
  SourceRange name_range;
  bool advanced;
  KindId kind;
  std::variant<ExternController, Retreat, Route, Yield> implementation;
};

// ---- properties -------------------------------------------------------------------------------

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

enum class Subject { self, other };  // the monitored robot, or the bound variable of `forall`
enum class Signal { battery, speed };

struct Constant {
  Rational value;
};
struct Truth {
  bool value;
};
struct SignalRef {  // r.battery, r.speed
  Subject subject;
  Signal signal;
};
struct Clearance {  // clearance(r, Z): gap between the body and the boundary, negative outside
  ZoneId zone;
};
struct Distance {};  // distance(r, q): gap between the two bodies, negative on overlap
struct EnergyTo {    // energy_to(dock(r)): upper bound of the charge that the way there takes
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
struct Expr {
  SourceRange range;
  bool boolean;  // else a quantity of `dimension`
  Dimension dimension;
  std::variant<Constant, Truth, SignalRef, Clearance, Distance, EnergyTo, InsideZone, PlanInside,
               Arithmetic, Compare, Logic, HeldFor, ForOthers>
      node;
};

// ---- monitors and decisions -------------------------------------------------------------------

struct Ahead {
  std::optional<Quantity> duration;  // none and not waypoints_only: derived from the period
  std::optional<std::string> duration_unsound;
  int waypoints = 0;  // 0: the plan is not looked at
  bool waypoints_only = false, points_only = false;
  std::string unsound_reason;  // of waypoints_only / points_only
  SourceRange range;           // of the clause, or of the monitor's name when there is none
};
struct Monitor {
  std::string name;
  SourceRange name_range, range;
  KindId kind;
  std::string requirement_id;    // "SR-3", the part before the first colon; may be empty
  std::string requirement_text;  // the rest
  ExprPtr always;
  SourceRange always_range;
  Ahead ahead;
  std::optional<ControllerId> recover;
  SourceRange recover_range;
  ExprPtr return_when;  // may be null
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
};

struct Spec {
  std::string name;
  SourceRange name_range;
  std::vector<Zone> zones;
  std::vector<RobotKind> kinds;
  std::vector<Robot> robots;  // in the order of the fleets
  std::vector<Site> sites;
  std::vector<Controller> controllers;
  std::vector<Monitor> monitors;
  std::vector<Decision> decisions;

  template <class Id, class T>
  static const T& at(const std::vector<T>& items, Id id) {
    return items[static_cast<std::uint32_t>(id)];
  }
  const Zone& operator[](ZoneId id) const { return at(zones, id); }
  const RobotKind& operator[](KindId id) const { return at(kinds, id); }
  const Robot& operator[](RobotId id) const { return at(robots, id); }
  const Site& operator[](SiteId id) const { return at(sites, id); }
  const Controller& operator[](ControllerId id) const { return at(controllers, id); }
  const Monitor& operator[](MonitorId id) const { return at(monitors, id); }
  const Decision& operator[](DecisionId id) const { return at(decisions, id); }
};

}  // namespace rtac::sema
