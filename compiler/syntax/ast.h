// The abstract syntax tree: what the author wrote, with places, before any meaning.
// Every node is a plain struct in a variant; a visitor without a default case keeps the phases
// complete. The canonical text of each node is printed by printer.h.
#pragma once

#include <memory>
#include <optional>
#include <set>
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
// [a, b] of a past operator or an aggregate; `to` null: inf.
struct Interval {
  ExprPtr from, to;
  SourceRange range;
};
struct Previously {  // previously φ
  ExprPtr operand;
};
enum class PastOp { once, historically };
struct Past {  // once[0 s, 2 s] φ; without an interval: [0 s, inf]
  PastOp op;
  std::optional<Interval> interval;
  ExprPtr operand;
};
struct Since {  // φ since[a, b] ψ
  std::optional<Interval> interval;
  ExprPtr left, right;
};
struct WithinOf {  // φ within 2 s of ψ
  ExprPtr operand, duration, trigger;
};
struct Aggregate {  // mean[0 s, 1 s](speed), count[0 s, 1 s](open); sema knows the names
  Name name;
  Interval interval;
  ExprPtr operand;
};
struct Conditional {  // if c then a else b
  ExprPtr condition, then_value, else_value;
};
struct Let {  // let x = e in f
  Name name;
  ExprPtr value, body;
};
struct Index {  // temps[2]
  ExprPtr base, index;
};
enum class Quantifier { forall, exists };
struct Quantified {  // forall q : Kind, q != r : body
  Quantifier quantifier;
  Name variable, kind;
  ExprPtr guard;  // may be null
  ExprPtr body;
};
struct OverFleet {  // min(q : Kind, q != r : x), count(q : Kind, q != r : φ); sema knows the names
  Name name;
  Name variable, kind;
  ExprPtr guard;  // may be null
  ExprPtr body;
};
struct PointLit {  // (1 m, 2 m)
  std::vector<ExprPtr> coordinates;
};
struct RectangleLit {  // rectangle (0 m, 0 m) to (5 m, 5 m); of space: a box
  ExprPtr from, to;
  bool says_box = false;  // box (0 m, 0 m, 0 m) to (5 m, 5 m, 3 m): of space alone
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
struct PrismLit {  // prism (field - pond) from 10 m to 50 m
  ExprPtr base, floor, ceiling;
};
// What a file leaves open, or what of it is meant: feature "hospital", in m, axes latitude
// longitude, inclusions all, exclusions, flat "why", timeless "why", heights sea at -432 m,
// scheduled.
enum class ImportWord {
  feature,
  unit,
  axes,
  inclusions,
  exclusions,
  flat,
  timeless,
  heights,
  scheduled
};
struct ImportOption {
  ImportWord word = ImportWord::feature;
  std::optional<Text> text;
  std::vector<Name> names;  // sema knows them
  SourceRange range;
  ExprPtr level = nullptr;  // of heights: where the reference is
};
struct ImportLit {  // import "city.geojson" feature "hospital"
  Text path;
  std::vector<ImportOption> options;
};
struct ErrorExpr {};  // stands where a syntax error was; sema stays silent about it

struct Expr {
  SourceRange range;
  std::variant<NumberLit, BoolLit, NameRef, Member, Call, Unary, Binary, Held, Previously, Past,
               Since, WithinOf, Aggregate, Conditional, Let, Index, Quantified, OverFleet, PointLit,
               RectangleLit, CircleLit, PolygonLit, PrismLit, ImportLit, ErrorExpr>
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
struct HearsClause {  // hears other robots max_age 200 ms, present
  ExprPtr max_age;
  bool present = false;  // messages say whether their sender is there: an open fleet
};
struct InputClause {  // input plan : path[64] tracking <= 10 cm
  Name name, type;
  ExprPtr capacity, tracking;  // either may be null
};
struct OutputClause {
  Name name, type;  // drive : twist, thrust : acceleration
  ExprPtr error{};  // null: not declared
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

struct ExternTemplate {  // extern;   extern keeps inside free speed <= 0.3 m/s
  std::optional<Name> zone;
  ExprPtr speed;
};
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
struct BrakeTemplate {};  // brake_and_hold
struct LoiterTemplate {   // loiter within free speed 0.1 m/s
  Name zone;
  ExprPtr speed;
};
struct LandTemplate {     // land to 0.5 m speed 0.3 m/s
  ExprPtr height, speed;  // null: not given
};
using SafeTemplate = std::variant<RetreatTemplate, RouteTemplate, YieldTemplate, BrakeTemplate,
                                  LoiterTemplate, LandTemplate>;
struct SequenceStep {
  SafeTemplate what;
  SourceRange range;
  ExprPtr lasts;  // null: the last step
};
struct SequenceTemplate {  // sequence brake_and_hold for 2 s then retreat within free speed 0.1 m/s
  std::vector<SequenceStep> steps;
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

// ---- types ------------------------------------------------------------------------------------

// bool | int | real | real [m/s] | point | vector | pose | twist | Gear, with [n] behind it for an
// array; `of base` says which frame a pose places, `@ gps` the frame of the coordinates.
struct TypeRef {
  Name name;
  std::optional<Unit> unit;     // of `real`; none: dimensionless
  std::vector<ExprPtr> length;  // of an array; empty: no array; sema takes one
  std::optional<Name> of, frame;
  SourceRange range;
};

// ---- items ------------------------------------------------------------------------------------

struct PeriodItem {  // period 10 ms;  of the monitors without a robot
  ExprPtr value;
};
struct Limits {  // a .. b
  ExprPtr least, most;
};
// input speed : real [m/s] in 0 .. 3 m/s error 1 cm/s max_age 100 ms;
// Of a pose and a twist, what is in the lists goes for their two parts: error 1 cm, 1 deg.
struct InputItem {
  std::vector<Name> names;
  TypeRef type;
  std::vector<Limits> limits;  // `in a .. b`
  std::vector<ExprPtr> error;
  ExprPtr max_age;  // null: none
  bool max_age_inf = false;
  std::vector<ExprPtr> resolution;  // `resolution 1 mm`; empty: that of the dimension
};
struct ParamItem {  // param h : length in 0.1 m .. 0.5 m = 0.2 m;
  Name name;
  TypeRef type;
  ExprPtr least, most, value;
};
struct EnumItem {  // enum Gear { park, drive, reverse }
  Name name;
  std::vector<Name> values;
};
struct FunItem {  // fun slow(v : real [m/s]) : bool = v <= 1 m/s;
  struct Parameter {
    Name name;
    TypeRef type;
  };
  Name name;
  std::vector<Parameter> parameters;
  TypeRef result;
  ExprPtr body;
};
struct ScaleItem {  // scale 0.5 m/s;  margins of speeds are compared in units of 0.5 m/s
  ExprPtr value;
};
struct GridItem {  // grid 0.1 mm, 1 mm/s;  the resolution of inputs of these dimensions
  std::vector<ExprPtr> steps;
};
struct FrameItem {  // frame gps, base;
  std::vector<Name> names;
};
struct OriginItem {  // origin 47.3977 deg, 8.5456 deg;   of the map: latitude, longitude, altitude
  std::vector<ExprPtr> values;
};
struct AssumeItem {  // assume φ checked by NAME;   assume φ unchecked "why";
  ExprPtr condition;
  std::optional<Name> checked_by;
  std::optional<Text> unchecked;
};

struct ImportItem {
  Text path;
};
struct ClockItem {  // clock utc;
  Name name;
};
// When a zone is there: 2026-05-01T08:00Z .. 2026-05-01T18:00Z;   monday, tuesday 07:30 .. 16:00;
struct Opening {
  std::vector<Name> days;
  Text from, until;  // moments
  SourceRange range;
};
struct RobotRef {  // r1, bots[3]
  Name name;
  ExprPtr number;  // null: none
  SourceRange range;
};
// zone yard = ...;   zone yard @ gps = ...;   zone yard = ... around r1 during ...;
struct ZoneItem {
  Name name;
  std::optional<Name> frame;  // none: map
  ExprPtr value;
  std::optional<RobotRef> around;  // the robot or point that it moves with
  std::vector<Opening> during;     // none: always
};
struct RobotItem {
  Name name;
  std::vector<RobotClause> clauses;
};
struct FleetItem {  // fleet r1, r2 : Cart;   fleet bots : Drone[128];
  std::vector<Name> members;
  Name kind;
  ExprPtr count;  // of numbered members; null: each name is a robot
};
// agent people[8] : radius 30 cm, speed <= 2 m/s error 10 cm max_age 200 ms, present;
// agent glider : point3, radius 2 m, speed <= 20 m/s error 1 m max_age 500 ms;
struct AgentItem {
  std::vector<Name> names;
  ExprPtr count;  // of numbered ones; null: each name is one
  ExprPtr radius, speed, error, max_age;
  bool present = false;
  std::optional<Name> type{};  // of its position; none: of the plane
};
struct SiteItem {  // site dock(r1) = (1 m, 1 m);   site home = (0 m, 0 m);
  Name name;
  std::optional<RobotRef> robot;
  ExprPtr position;
};
struct ControllerItem {
  Name name;
  Role role;
  Name kind;
  std::variant<ExternTemplate, RetreatTemplate, RouteTemplate, YieldTemplate, BrakeTemplate,
               LoiterTemplate, LandTemplate, SequenceTemplate>
      implementation;
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
  std::vector<SourceRange> margin_full;  // `margin full`
  std::vector<Text> hold;                // hold when violated "why"
};
struct DecisionItem {
  Name name, kind;
  std::vector<Name> advanced, safe, on;
  std::vector<ExprPtr> period;
  std::vector<std::vector<Name>> priority;
  std::vector<Acknowledge> acknowledge;
  std::vector<ExprPtr> jitter;
  std::vector<std::vector<Name>> coordinate;
};
struct Item {
  SourceRange range;
  std::variant<ImportItem, PeriodItem, InputItem, ParamItem, EnumItem, FunItem, ScaleItem, GridItem,
               FrameItem, OriginItem, ClockItem, AssumeItem, ZoneItem, RobotItem, FleetItem,
               AgentItem, SiteItem, ControllerItem, MonitorItem, DecisionItem>
      node;
  // A mistake in its text is reported and could only be mended by a guess, so that the tree may not
  // be what is meant.
  bool damaged = false;
};

// What mistakes that are reported have taken from the tree. Nothing is said about a name that may
// be declared there.
struct Loss {
  std::set<std::string> names;  // of the text that is not in the tree
  bool items = false;           // whole items are not in the tree
  bool rest = false;            // text that was not read at all: its names are not known
};

// One file. Comments are not in the tree; the formatter works from the token stream.
struct File {
  FileId id{};
  std::optional<Name> spec;  // an imported file has none
  std::vector<Item> items;
  std::vector<Text> zone_files;  // the paths of all ImportLit
  Loss loss;
};

// A file that zones are read from.
struct ZoneFile {
  FileId importer{};
  std::string written;  // the path in the importer
  std::string path;     // from here
  std::shared_ptr<const std::string> text;
};

// The root file and everything that it imports, importers after their imports, each file once.
struct Program {
  std::vector<File> files;
  std::vector<ZoneFile> zone_files;  // each importer and path once; what cannot be read is missing
  bool import_failed = false;        // the names of a file are not known
};

}  // namespace rtac::syntax
