// Legs and paths in monitors without a robot: places one after the other, and the straight ways
// between them; whether they lie in a zone, and how far they are from it, from a place, from one
// another.
#include "compiler/sema/heights.h"
#include "compiler/sema/property_checker.h"
#include "compiler/sema/zones.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

namespace {

bool is_way_function(const syntax::Expr& expr) {
  const auto* call = std::get_if<syntax::Call>(&expr.node);
  return call != nullptr && (call->callee.text == "leg" || call->callee.text == "path");
}

// The legs of a way one by one, then what is left of its path: of a way of one place the place.
std::vector<Trail> trails_of(const Way& way) {
  const auto put = [](Trail& to, const Pair& place) {
    to.own.push_back(clone(*place.x));
    to.own.push_back(clone(*place.y));
  };
  std::vector<Trail> trails;
  for (std::size_t i = 0; i + 1 < way.places.size(); ++i) {
    put(trails.emplace_back(), way.places[i]);
    put(trails.back(), way.places[i + 1]);
  }
  if (way.path || trails.empty()) {
    Trail& last = trails.emplace_back();
    if (!way.places.empty()) put(last, way.places.back());
    last.path = way.path;
    last.next_only = way.next_only;
  }
  return trails;
}

std::size_t size_of_places(const Way& way) {
  std::size_t size = 1;
  for (const Pair& place : way.places) size += size_of(Value(clone(place)));
  return size;
}

// What is said of it holds of nothing while the path is empty.
std::optional<InputId> may_be_empty(const Way& way) {
  return way.places.empty() ? way.path : std::nullopt;
}

}  // namespace

bool PropertyChecker::says_way(const syntax::Expr& expr) const {
  if (is_way_function(expr)) return true;
  const auto* member = std::get_if<syntax::Member>(&expr.node);
  if (member != nullptr) {
    return member->field.text == "plan" && sees_fleets() && names_robot(*member->base);
  }
  const syntax::Name* name = name_in(expr);
  if (name == nullptr) return false;
  if (const Local* bound = local(name->text)) {
    return std::holds_alternative<Way>(bound->value.node);
  }
  const Symbol* symbol = context_.symbols.find(name->text);
  return symbol != nullptr && symbol->sort == Sort::input &&
         context_.input_types[symbol->index].kind == TypeKind::path;
}

// `leg(p, q)`, `leg(p, plan)`, `path(p, q, ...)`, `path(p, ..., plan)`.
Value PropertyChecker::way_of(const syntax::Expr& expr, const syntax::Call& call) {
  const std::string& name = call.callee.text;
  const bool is_leg = name == "leg";
  if (is_leg && !argument_count(expr, call, 2, "leg(p, q)")) return nullptr;
  if (!is_leg && call.arguments.size() < 2) {
    context_.report(
        Finding(Code::wrong_argument_count, expr.range,
                "`path` takes two arguments or more, not " + std::to_string(call.arguments.size()))
            .label("like `path(p, q)`")
            .help("write `path(p, q)`, or a path that arrives by its name alone"));
    return nullptr;
  }
  Way way;
  way.frame.reset();
  way.next_only = is_leg;
  for (const syntax::ExprPtr& argument : call.arguments) {
    const bool is_last = argument == call.arguments.back();
    if (is_last && says_way(*argument)) return led_on(*argument, std::move(way));
    auto place = names_robot(*argument) ? body_in_way(*argument, name) : place_of(*argument, name);
    if (!place || !way_in_plane(*argument, *place) ||
        !frames_agree(argument->range, "`" + name + "`", way.frame, place->frame)) {
      return nullptr;
    }
    if (!way.frame) way.frame = place->frame;
    way.places.push_back(std::move(*place));
  }
  way.next_only = false;
  return way;
}

// `leg(cart, p)`: a way leads between points, and a body is none.
std::optional<Pair> PropertyChecker::body_in_way(const syntax::Expr& written,
                                                 const std::string& user) {
  const auto held = placed(written, user);
  if (!held) return std::nullopt;
  const std::string part = held->centre.z ? ".position.xy" : ".position";
  context_.report(
      Finding(Code::wrong_argument, written.range, "`" + user + "` leads between points")
          .label("this is a robot")
          .help("write `" + print_expr(written) + part + "`, the place of its centre")
          .insert_after(written.range, part));
  return std::nullopt;
}

bool PropertyChecker::way_in_plane(const syntax::Expr& written, const Pair& place) {
  if (!place.z) return true;
  Finding finding(Code::spaces_differ, written.range, "legs and paths lie in the plane");
  finding.label("this has three coordinates");
  if (std::holds_alternative<syntax::PointLit>(written.node)) {
    context_.report(finding.help("leave out its height, the third coordinate"));
    return false;
  }
  const bool of_body = names_robot(written);
  const std::string part = of_body ? ".position.xy" : ".xy";
  finding
      .help("write `" + print_expr(written) + part + "`, " +
            (of_body ? "the place of its centre in the plane" : "its part in the plane"))
      .insert_after(written.range, part);
  context_.report(finding);
  return false;
}

// Places of its own, then what is left of a path.
Value PropertyChecker::led_on(const syntax::Expr& written, Way way) {
  Value behind = infer(written);
  auto* path = std::get_if<Way>(&behind.node);
  if (path == nullptr) return nullptr;
  if (!path->places.empty()) {
    context_.report(Finding(Code::wrong_argument, written.range,
                            "what stands behind a place is a place, or a path that arrives")
                        .label("made of places itself")
                        .help("list the places one by one: `path(p, q, r)`"));
    return nullptr;
  }
  if (!frames_agree(written.range, "a path", way.frame, path->frame)) return nullptr;
  way.frame = path->frame;
  way.path = path->path;
  return way;
}

bool PropertyChecker::ways_allowed(const syntax::Expr& expr) {
  if (!scope_.of_robot()) return true;
  context_.report(Finding(Code::wrong_argument, expr.range,
                          "legs and paths are judged by monitors without a robot")
                      .label("in the monitor of a robot")
                      .help("here `ahead 2 waypoints` judges the plan of the robot leg by leg; a "
                            "monitor without `for` judges legs and paths"));
  return false;
}

// What stands for a way: itself, or a place alone; a body with its radius.
std::optional<PropertyChecker::HeldWay> PropertyChecker::held_way(const syntax::Expr& expr,
                                                                  const std::string& user) {
  if (says_way(expr)) {
    if (!ways_allowed(expr)) return std::nullopt;
    Value value = infer(expr);
    auto* way = std::get_if<Way>(&value.node);
    return way != nullptr ? std::optional(HeldWay{std::move(*way), 0}) : std::nullopt;
  }
  auto held = placed(expr, user);
  if (!held || !way_in_plane(expr, held->centre)) return std::nullopt;
  Way way;
  way.frame = held->centre.frame;
  way.places.push_back(std::move(held->centre));
  return HeldWay{std::move(way), held->radius};
}

// The zone of the plane that a way is held against.
std::optional<ZoneId> PropertyChecker::zone_around_way(const Way& way, const syntax::Expr& zone) {
  const auto id = zone_around(way.frame, false, zone);
  if (!id) return std::nullopt;
  const std::uint32_t index = index_of(*id);
  const bool moves = index < context_.zones.size() && context_.zones[index].node->around;
  if (!moves) return id;
  context_.report(
      Finding(Code::zone_not_fixed, zone.range, "a leg or a path is held against a zone that moves")
          .label("it moves")
          .help("hold the way against what the zone moves with: `distance(plan, p) >= "
                "2 m`"));
  return std::nullopt;
}

ExprPtr PropertyChecker::extreme_of(const SourceRange& range, std::vector<ExprPtr> gaps,
                                    bool greatest) {
  if (gaps.size() == 1) return std::move(gaps.front());
  return make_quantity(range, dims::length,
                       Math{greatest ? MathOp::maximum : MathOp::minimum, std::move(gaps)});
}

ExprPtr PropertyChecker::while_given(const SourceRange& range, const Way& way, ExprPtr gap) {
  const auto path = may_be_empty(way);
  return path ? make_quantity(range, dims::length, WhileOpen{*path, true, std::move(gap)})
              : std::move(gap);
}

// Every place of it lies in the zone. A complement is open: its boundary belongs to the zone.
ExprPtr PropertyChecker::way_inside(const syntax::Expr& expr, const syntax::Binary& binary) {
  const auto held = held_way(*binary.left, "inside");
  const auto zone = held ? zone_around_way(held->way, *binary.right) : std::nullopt;
  if (!zone || !affordable(expr, 2 * size_of_places(held->way))) return nullptr;
  const auto of = complemented(context_.spec, *zone);
  std::vector<ExprPtr> parts;
  for (Trail& trail : trails_of(held->way)) {
    parts.push_back(make_condition(
        expr.range, TrailInside{std::move(trail), of.value_or(*zone), of.has_value()}));
  }
  ExprPtr all = parts.size() == 1
                    ? std::move(parts.front())
                    : make_condition(expr.range, Logic{LogicOp::logical_and, std::move(parts)});
  all = inside_while_open(expr.range, *zone, std::move(all));
  const auto path = may_be_empty(held->way);
  if (!path) return all;
  ExprPtr given = make_condition(expr.range, PathGiven{*path});
  return make_condition(expr.range,
                        Logic{LogicOp::implies, operands_of(std::move(given), std::move(all))});
}

// The least clearance of its places, or the greatest.
ExprPtr PropertyChecker::gap_of_way(const SourceRange& range, const Way& way, ZoneId zone,
                                    bool greatest) {
  if (const auto of = complemented(context_.spec, zone)) {
    ExprPtr gap = gap_of_way(range, way, *of, !greatest);
    return make_quantity(range, dims::length,
                         Arithmetic{ArithmeticOp::negate, operands_of(std::move(gap))});
  }
  std::vector<ExprPtr> gaps;
  for (Trail& trail : trails_of(way)) {
    gaps.push_back(
        make_quantity(range, dims::length, TrailClearance{std::move(trail), zone, greatest}));
  }
  return extreme_of(range, std::move(gaps), greatest);
}

ExprPtr PropertyChecker::clearance_of_way(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "clearance(plan, zone)")) return nullptr;
  const auto held = held_way(*call.arguments[0], "clearance");
  const auto zone = held ? zone_around_way(held->way, *call.arguments[1]) : std::nullopt;
  if (!zone || !affordable(expr, 2 * size_of_places(held->way))) return nullptr;
  ExprPtr gap = gap_of_way(expr.range, held->way, *zone, false);
  return while_given(expr.range, held->way,
                     gap_while_open(expr.range, *zone, false, std::move(gap)));
}

// From a zone: nothing where a part of it lies in the zone.
ExprPtr PropertyChecker::way_from_zone(const syntax::Expr& expr, const HeldWay& held,
                                       const syntax::Expr& written) {
  const auto zone = zone_around_way(held.way, written);
  if (!zone || !affordable(expr, 2 * size_of_places(held.way))) return nullptr;
  ExprPtr outside = make_quantity(
      expr.range, dims::length,
      Arithmetic{ArithmeticOp::negate, operands_of(gap_of_way(expr.range, held.way, *zone, true))});
  ExprPtr nothing = make_quantity(expr.range, dims::length, Constant{0});
  ExprPtr gap =
      make_quantity(expr.range, dims::length,
                    Math{MathOp::maximum, operands_of(std::move(nothing), std::move(outside))});
  return while_given(expr.range, held.way, gap_while_open(expr.range, *zone, true, std::move(gap)));
}

// One of both is a leg or a path; the other one as well, or a place, a body, a zone.
ExprPtr PropertyChecker::distance_of_ways(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "distance(plan, p)")) return nullptr;
  const syntax::Expr& first = *call.arguments[0];
  const syntax::Expr& second = *call.arguments[1];
  if (is_error(first) || is_error(second)) return nullptr;
  if (says_zone(first) || says_zone(second)) {
    const bool swapped = says_zone(first);
    const auto held = held_way(swapped ? second : first, "distance");
    return held ? way_from_zone(expr, *held, swapped ? first : second) : nullptr;
  }
  const auto one = held_way(first, "distance");
  const auto other = one ? held_way(second, "distance") : std::nullopt;
  if (!other || !frames_agree(expr.range, "`distance`", one->way.frame, other->way.frame)) {
    return nullptr;
  }
  // each leg of one is copied for each of the other one
  const std::size_t legs = one->way.places.size() + 1, others = other->way.places.size() + 1;
  if (!affordable(expr,
                  2 * (size_of_places(one->way) * others + size_of_places(other->way) * legs))) {
    return nullptr;
  }
  std::vector<ExprPtr> gaps;
  for (const Trail& a : trails_of(one->way)) {
    for (const Trail& b : trails_of(other->way)) {
      gaps.push_back(make_quantity(expr.range, dims::length, TrailDistance{clone(a), clone(b)}));
    }
  }
  ExprPtr gap = less_radius(expr, extreme_of(expr.range, std::move(gaps), false),
                            Rational(one->radius + other->radius));
  return while_given(expr.range, one->way, while_given(expr.range, other->way, std::move(gap)));
}

}  // namespace rtac::sema
