// What a monitor without a robot says about places: a point or the body of a robot lies in a zone,
// and how far from its boundary.
#include <algorithm>

#include "compiler/sema/heights.h"
#include "compiler/sema/property_checker.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {
namespace {

// The clearance of several legs.
bool is_least_of_ways(const Expr& gap) {
  const auto* math = std::get_if<Math>(&gap.node);
  return math != nullptr && math->op == MathOp::minimum &&
         std::ranges::all_of(math->operands, [](const ExprPtr& each) {
           const auto* way = std::get_if<TrailClearance>(&each->node);
           return way != nullptr && !way->greatest;
         });
}

}  // namespace

using syntax::BinaryOp;

// Does it say a zone, rather than a point or a robot?
bool PropertyChecker::says_zone(const syntax::Expr& expr) const {
  if (names_zone(expr) || form_of(expr) == "a zone") return true;
  if (const auto* call = std::get_if<syntax::Call>(&expr.node)) {
    return is_zone_function(call->callee.text);
  }
  const auto* binary = std::get_if<syntax::Binary>(&expr.node);
  if (binary == nullptr) return false;
  const bool joins = binary->op == BinaryOp::zone_union ||
                     binary->op == BinaryOp::zone_intersection || binary->op == BinaryOp::subtract;
  return joins && says_zone(*binary->left);
}

// The place of what stands here, in length: a point, or the body of a robot around its centre.
std::optional<PropertyChecker::Placed> PropertyChecker::placed(const syntax::Expr& expr,
                                                               const std::string& user) {
  if (!place_known(expr, places_of_robots())) return std::nullopt;
  if (!names_robot(expr)) {
    auto point = place_of(expr, user);
    return point ? std::optional(Placed{std::move(*point), 0}) : std::nullopt;
  }
  if (function_ != nullptr) {
    robot_allowed(expr.range, "`" + user + "` of a body");
    return std::nullopt;
  }
  const auto robot = robot_named(expr);
  const auto input = robot ? robot_input(*robot, "position", expr.range) : std::nullopt;
  if (!input) return std::nullopt;
  Value centre = input_value(expr.range, *input);
  auto* pair = std::get_if<Pair>(&centre.node);
  if (pair == nullptr) return std::nullopt;
  return Placed{std::move(*pair), context_.spec[context_.spec[*robot].kind].radius.value};
}

PropertyChecker::Centre PropertyChecker::centre_of(Pair& place) {
  return {std::move(place.x), std::move(place.y), std::move(place.z)};
}

// The place that a point is, in length.
std::optional<Pair> PropertyChecker::place_of(const syntax::Expr& expr, const std::string& user) {
  auto place = pair_of(expr, Pair::Kind::point, user);
  if (!place) return std::nullopt;
  if (place->x->dimension == dims::length) return place;
  context_.report(
      Finding(Code::wrong_dimension, expr.range,
              "`" + user + "` takes a place, its coordinates are " + describe(place->x->dimension))
          .label("not in length")
          .help("write the coordinates with their unit, `(1 m, 2 m)`"));
  return std::nullopt;
}

// The zone that a place is held against, in the frame of the place: a literal, which has none, is
// in that of the zone.
std::optional<ZoneId> PropertyChecker::zone_around(const std::optional<FrameId>& of, bool in_space,
                                                   const syntax::Expr& zone) {
  const syntax::Name* name = name_in(zone);
  const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
  const bool received = symbol != nullptr && is_received_zone(context_, *symbol);
  if (received && !signal_allowed(zone.range, *name, Sort::input)) return std::nullopt;
  const FrameId frame = of ? *of : frame_of_zone(context_, zone);
  const Change change = scope_.of_robot() ? Change::refused : Change::allowed;
  const auto id = zone_in_property(context_, zone, frame, change, Height::allowed);
  if (!id || has_height(context_, zone) == in_space) return id;
  if (height_is_open(context_, zone)) return std::nullopt;
  Finding finding(Code::spaces_differ, zone.range,
                  in_space ? "a point of space is held against a zone of the plane"
                           : "a place in the plane is held against a zone with height");
  finding.label(in_space ? "this zone lies in the plane" : "this zone has height");
  finding.help(in_space
                   ? "say how high the zone reaches, `prism (zone) from 0 m to 50 m`, or write "
                     "`.xy` for the part of the point in the plane"
                   : "an input of type `point3` has a height; robots move in the plane, and are "
                     "held against zones of the plane");
  context_.report(finding);
  return std::nullopt;
}

// The place as it is seen from what the zone moves with; false: reported.
bool PropertyChecker::seen_from_carrier(const syntax::Expr& expr, ZoneId zone, Pair& place) {
  const std::uint32_t index = index_of(zone);
  const bool moves = index < context_.zones.size() && context_.zones[index].node->around;
  if (!moves) return true;
  const syntax::RobotRef& around = *context_.zones[index].node->around;
  const auto carrier = context_.carriers.find(zone);
  if (carrier == context_.carriers.end()) return false;
  if (!signal_allowed(expr.range, around.name, Sort::input)) return false;
  const auto* robot = std::get_if<RobotId>(&carrier->second);
  const auto input = robot != nullptr ? robot_input(*robot, "position", around.range)
                                      : std::optional(std::get<InputId>(carrier->second));
  Value from = input ? input_value(expr.range, *input) : nullptr;
  auto* centre = std::get_if<Pair>(&from.node);
  if (centre == nullptr) return false;
  place.x = sum(expr, ArithmeticOp::subtract, std::move(place.x), std::move(centre->x));
  place.y = sum(expr, ArithmeticOp::subtract, std::move(place.y), std::move(centre->y));
  if (place.z) {
    place.z = sum(expr, ArithmeticOp::subtract, std::move(place.z), std::move(centre->z));
  }
  return true;
}

// A zone that is not open is empty.
ExprPtr PropertyChecker::inside_while_open(const SourceRange& range, ZoneId zone, ExprPtr inside) {
  if (context_.spec[zone].openings.empty()) return inside;
  ExprPtr open = make_condition(range, ZoneOpen{zone});
  return make_condition(
      range, Logic{LogicOp::logical_and, operands_of(std::move(open), std::move(inside))});
}
ExprPtr PropertyChecker::gap_while_open(const SourceRange& range, ZoneId zone, bool endless,
                                        ExprPtr gap) {
  if (context_.spec[zone].openings.empty()) return gap;
  return make_quantity(range, dims::length, WhileOpen{zone, endless, std::move(gap)});
}

// A gap to the centre of a body is wider than that to the body.
ExprPtr PropertyChecker::less_radius(const syntax::Expr& expr, ExprPtr gap,
                                     const Rational& radius) {
  if (radius == 0) return gap;
  ExprPtr reach = make_quantity(expr.range, dims::length, Constant{radius, true});
  return make_quantity(
      expr.range, dims::length,
      Arithmetic{ArithmeticOp::subtract, operands_of(std::move(gap), std::move(reach))});
}

// The complement of a zone is open: its boundary is that of the zone, and belongs to the zone.
ExprPtr PropertyChecker::inside_of(const syntax::Expr& expr, Centre place, ZoneId zone) {
  if (const auto of = complemented(context_.spec, zone)) {
    ExprPtr in = inside_of(expr, std::move(place), *of);
    return make_condition(expr.range, Logic{LogicOp::logical_not, operands_of(std::move(in))});
  }
  return make_condition(
      expr.range, PointInside{std::move(place.x), std::move(place.y), std::move(place.z), zone});
}

// The distance of a place to the boundary, negative outside.
ExprPtr PropertyChecker::gap_of(const syntax::Expr& expr, Centre place, ZoneId zone) {
  if (const auto of = complemented(context_.spec, zone)) {
    ExprPtr gap = gap_of(expr, std::move(place), *of);
    return make_quantity(expr.range, dims::length,
                         Arithmetic{ArithmeticOp::negate, operands_of(std::move(gap))});
  }
  return make_quantity(
      expr.range, dims::length,
      PointClearance{std::move(place.x), std::move(place.y), std::move(place.z), zone});
}

// A place, or a way, whose clearance is at least 0 m lies inside, which is known better than how
// far from the boundary it is: both are one condition.
ExprPtr PropertyChecker::comparison(const SourceRange& range, CompareOp op, ExprPtr left,
                                    ExprPtr right) {
  const bool at_most = op == CompareOp::less || op == CompareOp::less_equal;
  const bool strict = op == CompareOp::less || op == CompareOp::greater;
  const bool of_left = at_most == strict;  // the gap, if it is one
  const auto* bound = std::get_if<Constant>(&(of_left ? right : left)->node);
  Expr& gap = of_left ? *left : *right;
  auto* place = std::get_if<PointClearance>(&gap.node);
  auto* way = std::get_if<TrailClearance>(&gap.node);
  const bool lies = place != nullptr || (way != nullptr && !way->greatest);
  if (bound == nullptr || bound->value != 0 || !(lies || is_least_of_ways(gap))) {
    return make_condition(range, Compare{op, std::move(left), std::move(right)});
  }
  if (!lies) {  // each of them
    std::vector<ExprPtr> parts;
    for (ExprPtr& each : std::get<Math>(gap.node).operands) {
      ExprPtr zero = make_quantity(range, dims::length, Constant{0});
      parts.push_back(of_left ? comparison(range, op, std::move(each), std::move(zero))
                              : comparison(range, op, std::move(zero), std::move(each)));
    }
    return joined(range, strict ? LogicOp::logical_or : LogicOp::logical_and, std::move(parts));
  }
  ExprPtr in = place != nullptr
                   ? make_condition(range, PointInside{std::move(place->x), std::move(place->y),
                                                       std::move(place->z), place->zone})
                   : make_condition(range, TrailInside{std::move(way->trail), way->zone, false});
  if (!strict) return in;
  return make_condition(range, Logic{LogicOp::logical_not, operands_of(std::move(in))});
}

ExprPtr PropertyChecker::point_inside(const syntax::Expr& expr, const syntax::Binary& binary) {
  if (is_error(*binary.left) || is_error(*binary.right)) return nullptr;
  if (says_way(*binary.left)) return way_inside(expr, binary);
  auto held = placed(*binary.left, "inside");
  const auto zone = held ? zone_around(held->centre.frame, held->centre.z != nullptr, *binary.right)
                         : std::nullopt;
  if (!zone || !seen_from_carrier(expr, *zone, held->centre)) return nullptr;
  Centre centre = centre_of(held->centre);
  if (held->radius == 0) {
    return inside_while_open(expr.range, *zone, inside_of(expr, std::move(centre), *zone));
  }
  ExprPtr gap = less_radius(expr, gap_of(expr, std::move(centre), *zone), held->radius);
  ExprPtr none = make_quantity(expr.range, dims::length, Constant{0});
  const bool open = complemented(context_.spec, *zone).has_value();
  return inside_while_open(
      expr.range, *zone,
      make_condition(expr.range, Compare{open ? CompareOp::greater : CompareOp::greater_equal,
                                         std::move(gap), std::move(none)}));
}

// How far two zones are apart; nothing where they meet.
ExprPtr PropertyChecker::distance_of_zones(const syntax::Expr& expr, const syntax::Expr& first,
                                           const syntax::Expr& second) {
  if (scope_.of_robot()) {  // in a function that its monitor calls, too
    context_.report(
        Finding(Code::wrong_argument, expr.range,
                "how far two zones are apart does not depend on `" + scope_.self.text + "`")
            .label("no distance of a robot")
            .help("write it in a monitor without `for`: `monitor apart { \"...\" "
                  "always distance(one, other) >= 1 m; }`"));
    return nullptr;
  }
  const FrameId frame = frame_of_zone(context_, first);
  const auto in_frame = [&](const syntax::Expr& zone) {
    return zone_in_property(context_, zone, frame, Change::apart, Height::allowed);
  };
  const auto one = in_frame(first), other = in_frame(second);
  const ZonePair both{first, second, expr.range, "held against"};
  if (!one || !other || !heights_agree(context_, both)) return nullptr;
  ExprPtr gap = make_quantity(expr.range, dims::length, ZoneDistance{*one, *other});
  return gap_while_open(expr.range, *one, true,
                        gap_while_open(expr.range, *other, true, std::move(gap)));
}

// `clearance(p, Z)` or `distance(p, Z)`: the distance of the place, the centre of a body, to the
// boundary, negative outside; and the radius of the body.
std::optional<PropertyChecker::CentreGap> PropertyChecker::centre_gap(const syntax::Expr& expr,
                                                                      const syntax::Call& call,
                                                                      const std::string& user) {
  if (!argument_count(expr, call, 2, user + "(p, zone)")) return std::nullopt;
  // a distance is the same from either side
  const bool swapped = user == "distance" && says_zone(*call.arguments[0]);
  const syntax::Expr& first = *call.arguments[swapped ? 1 : 0];
  const syntax::Expr& second = *call.arguments[swapped ? 0 : 1];
  if (is_error(first) || is_error(second)) return std::nullopt;
  if (says_zone(first) && says_zone(second)) {
    context_.report(Finding(Code::wrong_argument, expr.range, "`clearance` takes one zone")
                        .label("two zones")
                        .help("how far two zones are apart is `distance(one, other)`"));
    return std::nullopt;
  }
  if (says_zone(first)) {
    const std::string what = names_robot(second) ? "robot" : "point";
    context_.report(
        Finding(Code::wrong_argument, first.range, "`" + user + "` takes the " + what + " first")
            .label("the zone stands first")
            .help("swap them: `" + user + "(" + (names_robot(second) ? "robot" : "p") +
                  ", zone)`"));
    return std::nullopt;
  }
  auto held = placed(first, user);
  const auto zone =
      held ? zone_around(held->centre.frame, held->centre.z != nullptr, second) : std::nullopt;
  if (!zone || !seen_from_carrier(expr, *zone, held->centre)) return std::nullopt;
  Centre centre = centre_of(held->centre);
  return CentreGap{gap_of(expr, std::move(centre), *zone), held->radius, *zone};
}

ExprPtr PropertyChecker::clearance_of_place(const syntax::Expr& expr, const syntax::Call& call) {
  if (!call.arguments.empty() && says_way(*call.arguments[0])) return clearance_of_way(expr, call);
  auto found = centre_gap(expr, call, call.callee.text);
  if (!found) return nullptr;
  return gap_while_open(expr.range, found->zone, false,
                        less_radius(expr, std::move(found->gap), found->radius));
}

// Of a point nothing inside, the clearance turned round outside; bodies reach further by their
// radius, so that those which overlap the zone have a negative one.
ExprPtr PropertyChecker::distance_to_zone(const syntax::Expr& expr, const syntax::Call& call) {
  const auto& given = call.arguments;
  if (given.size() == 2 && says_zone(*given[0]) && says_zone(*given[1])) {
    return distance_of_zones(expr, *given[0], *given[1]);
  }
  auto found = centre_gap(expr, call, "distance");
  if (!found) return nullptr;
  ExprPtr outside =
      make_quantity(expr.range, dims::length,
                    Arithmetic{ArithmeticOp::negate, operands_of(std::move(found->gap))});
  ExprPtr nothing = make_quantity(expr.range, dims::length, Constant{0});
  ExprPtr gap =
      make_quantity(expr.range, dims::length,
                    Math{MathOp::maximum, operands_of(std::move(nothing), std::move(outside))});
  return gap_while_open(expr.range, found->zone, true,
                        less_radius(expr, std::move(gap), found->radius));
}

}  // namespace rtac::sema
