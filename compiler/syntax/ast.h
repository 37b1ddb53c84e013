// The abstract syntax tree: what the author wrote, with places, before any meaning.
// Every node is a plain struct in a variant; a visitor without a default case keeps the phases
// complete. The canonical text of each node is printed by printer.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/support/rational.h"
#include "compiler/support/source.h"

namespace rtac::syntax {

struct Name {
  std::string text;
  SourceRange range;
};

// A string literal without its quotes and with escapes resolved.
struct Text {
  std::string text;
  SourceRange range;
};

// A unit as written: `m/s^2`, `%/m`, `deg`. Its meaning is found by sema.
struct Unit {
  std::string text;
  SourceRange range;
};

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

// ---- expressions: numbers, points and zones share one grammar -------------------------------

struct NumberLit {
  Rational value;
  std::string text;          // as written
  std::optional<Unit> unit;  // none: dimensionless, or the author forgot it
};
struct BoolLit {
  bool value;
};
struct NameRef {
  Name name;
};
struct Member {  // r.battery
  ExprPtr base;
  Name field;
};
struct Call {  // clearance(r, free), dock(r1), shrink(free, 15 cm)
  Name callee;
  std::vector<ExprPtr> arguments;
};
enum class UnaryOp { negate, logical_not };
struct Unary {
  UnaryOp op;
  ExprPtr operand;
};
enum class BinaryOp {
  // logic, weakest first
  iff,
  implies,
  logical_xor,
  logical_or,
  logical_and,
  // comparison
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  inside,  // r inside Z, r.plan inside Z
  // zone algebra: union, intersection; difference is `subtract`
  zone_union,
  zone_intersection,
  // arithmetic
  add,
  subtract,
  multiply,
  divide,
};
struct Binary {
  BinaryOp op;
  ExprPtr left, right;
  SourceRange op_range;
};
struct Held {  // φ for 1 s
  ExprPtr operand, duration;
};
enum class Quantifier { forall, exists };
struct Quantified {  // forall q : Kind, q != r : body
  Quantifier quantifier;
  Name variable, kind;
  ExprPtr guard;  // may be null
  ExprPtr body;
};
struct PointLit {  // (1 m, 2 m)
  std::vector<ExprPtr> coordinates;
};
struct RectangleLit {  // rectangle (0 m, 0 m) to (5 m, 5 m)
  ExprPtr from, to;
};
struct CircleLit {  // circle (1 m, 1 m) radius 30 cm
  ExprPtr centre, radius;
};
struct PolygonLit {  // polygon [p, p, p] hole [p, p, p]
  struct Ring {
    std::vector<ExprPtr> points;
    SourceRange range;
  };
  Ring outer;
  std::vector<Ring> holes;
};
struct ErrorExpr {};  // stands where a syntax error was; sema stays silent about it

struct Expr {
  SourceRange range;
  std::variant<NumberLit, BoolLit, NameRef, Member, Call, Unary, Binary, Held, Quantified, PointLit,
               RectangleLit, CircleLit, PolygonLit, ErrorExpr>
      node;
};

// ---- robots -----------------------------------------------------------------------------------

enum class Relation { at_most, at_least };

struct Bound {  // speed <= 0.22 m/s   |   charge >= 1 %/s at dock
  Name name;
  Relation relation;
  ExprPtr value;
  std::optional<Name> at;  // site family, only in `energy`
};
struct BodyClause {
  ExprPtr radius;
};
struct MotionClause {
  Name model;  // point | unicycle
  std::vector<Bound> bounds;
};
struct SenseClause {
  Name name;               // position, heading, velocity, battery
  Name type;               // point, angle, vector, ratio
  ExprPtr error, max_age;  // either may be null: sema reports it
};
struct HearsClause {  // hears other robots max_age 200 ms
  ExprPtr max_age;
};
struct InputClause {  // input plan : path[64] tracking <= 10 cm
  Name name, type;
  ExprPtr capacity, tracking;  // either may be null
};
struct OutputClause {
  Name name, type;  // drive : twist, thrust : acceleration
};
struct LatencyClause {
  ExprPtr value;
};
struct EnergyClause {
  std::vector<Bound> bounds;
};
struct RobotClause {
  SourceRange range;
  std::variant<BodyClause, MotionClause, SenseClause, HearsClause, InputClause, OutputClause,
               LatencyClause, EnergyClause>
      node;
};

// ---- controllers ------------------------------------------------------------------------------

struct ExternTemplate {};
struct RetreatTemplate {  // retreat within free speed 0.1 m/s
  Name zone;
  ExprPtr speed;
};
struct RouteTemplate {  // route to dock within free speed 0.15 m/s
  Name site, zone;
  ExprPtr speed;
};
struct YieldTemplate {  // yield within free speed 0.1 m/s order id
  Name zone;
  ExprPtr speed;
  Name order;  // id
};
enum class Role { advanced, safe };

// ---- monitors and decisions -------------------------------------------------------------------

struct AheadDuration {
  ExprPtr duration;
  std::optional<Text> unsound;  // allows a duration below the module's reaction time
};
struct AheadWaypoints {
  ExprPtr count;
};
struct WaypointsOnly {
  std::optional<Text> unsound;
};
struct PointsOnly {
  std::optional<Text> unsound;
};
struct AheadTerm {
  SourceRange range;
  std::variant<AheadDuration, AheadWaypoints, WaypointsOnly, PointsOnly> node;
};

struct Acknowledge {
  SourceRange range;
  Name recovery, monitor;
  Text reason;
};

// ---- items ------------------------------------------------------------------------------------

struct ImportItem {
  Text path;
};
struct ZoneItem {
  Name name;
  ExprPtr value;
};
struct RobotItem {
  Name name;
  std::vector<RobotClause> clauses;
};
struct FleetItem {
  std::vector<Name> members;
  Name kind;
};
struct SiteItem {  // site dock(r1) = (1 m, 1 m);   site home = (0 m, 0 m);
  Name name;
  std::optional<Name> robot;
  ExprPtr position;
};
struct ControllerItem {
  Name name;
  Role role;
  Name kind;
  std::variant<ExternTemplate, RetreatTemplate, RouteTemplate, YieldTemplate> implementation;
  SourceRange implementation_range;
};
struct MonitorItem {
  Name name;
  std::optional<Name> variable, kind;  // none: a monitor without a robot
  std::vector<Text> requirement;       // as many as written; sema wants exactly one
  std::vector<ExprPtr> always;         // likewise
  std::vector<AheadTerm> ahead;
  std::vector<Name> recover;
  std::vector<ExprPtr> return_when;
};
struct DecisionItem {
  Name name, kind;
  std::vector<Name> advanced, safe, on;
  std::vector<ExprPtr> period;
  std::vector<std::vector<Name>> priority;
  std::vector<Acknowledge> acknowledge;
};
struct Item {
  SourceRange range;
  std::variant<ImportItem, ZoneItem, RobotItem, FleetItem, SiteItem, ControllerItem, MonitorItem,
               DecisionItem>
      node;
};

// One file. Comments are not in the tree; the formatter works from the token stream.
struct File {
  FileId id{};
  std::optional<Name> spec;  // an imported file has none
  std::vector<Item> items;
};

// The root file and everything that it imports, importers after their imports, each file once.
struct Program {
  std::vector<File> files;
};

}  // namespace rtac::syntax
