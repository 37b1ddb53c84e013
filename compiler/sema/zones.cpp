#include "compiler/sema/zones.h"

#include <algorithm>

#include "compiler/sema/frames.h"
#include "compiler/sema/import_schedule.h"
#include "compiler/sema/imports.h"
#include "compiler/sema/openings.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/suggest.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

using syntax::BinaryOp;

namespace {

ZoneExprPtr make(const SourceRange& range, decltype(ZoneExpr::node) node) {
  return std::make_unique<ZoneExpr>(ZoneExpr{range, std::move(node)});
}

class ZoneChecker {
 public:
  // `frame`: of the whole zone. `declared`: the value of a declaration, which may have windows of
  // time; what is within it, or within a property, has none.
  ZoneChecker(Context& context, FrameId frame, const syntax::Expr* declared = nullptr)
      : context_(context), frame_(frame), declared_(declared) {}

  ZoneExprPtr check(const syntax::Expr& expr) {
    return std::visit([&](const auto& node) { return zone(expr, node); }, expr.node);
  }

 private:
  ZoneExprPtr zone(const syntax::Expr&, const syntax::ErrorExpr&) { return nullptr; }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::NameRef& reference) {
    const auto id =
        zone_in_frame(context_, reference.name, frame_, Change::refused, Height::allowed);
    return id ? make(expr.range, ZoneRef{*id}) : nullptr;
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::RectangleLit& rectangle) {
    if (has_height(context_, expr)) return box_over(expr, rectangle);
    const auto from = check_point(context_, *rectangle.from, "a corner of a rectangle");
    const auto to = check_point(context_, *rectangle.to, "a corner of a rectangle");
    if (!from || !to) return nullptr;
    if (from->x == to->x || from->y == to->y) {
      const bool narrow = from->x == to->x;
      context_.report(Finding(Code::rectangle_degenerate, expr.range,
                              std::string("the rectangle has no area: both corners have ") +
                                  (narrow ? "x = " : "y = ") +
                                  show(narrow ? from->x : from->y, dims::length))
                          .label("no area")
                          .help("give two corners that lie diagonally opposite"));
      return nullptr;
    }
    const auto [left, right] = std::minmax(from->x, to->x);
    const auto [bottom, top] = std::minmax(from->y, to->y);
    ZonePolygon polygon;
    polygon.outer.points = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    polygon.outer.range = expr.range;
    for (const Point& corner : polygon.outer.points) {
      const bool at_from = corner.x == from->x && corner.y == from->y;
      const bool at_to = corner.x == to->x && corner.y == to->y;
      polygon.outer.point_ranges.push_back(at_from ? rectangle.from->range
                                                   : (at_to ? rectangle.to->range : expr.range));
    }
    return make(expr.range, std::move(polygon));
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::CircleLit& circle) {
    const auto centre = check_point(context_, *circle.centre, "the centre of a circle");
    const auto radius = quantity(context_, *circle.radius,
                                 {dims::length, "the radius of a circle", Limit::positive});
    if (!centre || !radius) return nullptr;
    return make(expr.range, ZoneCircle{*centre, radius->value});
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::PolygonLit& written) {
    ZonePolygon polygon;
    bool good = ring(written.outer, polygon.outer);
    for (const auto& hole : written.holes) good = ring(hole, polygon.holes.emplace_back()) && good;
    return good ? make(expr.range, std::move(polygon)) : nullptr;
  }

  bool ring(const syntax::PolygonLit::Ring& written, ZonePolygon::Ring& ring) {
    bool good = true;
    ring.range = written.range;
    for (const syntax::ExprPtr& vertex : written.points) {
      const auto point = check_point(context_, *vertex, "a vertex of a polygon");
      good = good && point.has_value();
      ring.points.push_back(point.value_or(Point{}));
      ring.point_ranges.push_back(vertex->range);
    }
    return good;
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::PrismLit& written) {
    const bool flat = lies_in_plane(context_, *written.base, "the base of a prism");
    ZoneExprPtr base = check(*written.base);
    const auto band = check_band(context_, expr, written);
    if (!flat || !base || !band) return nullptr;
    return make(expr.range, ZonePrism{std::move(base), band->floor, band->ceiling});
  }
  ZoneExprPtr box_over(const syntax::Expr& expr, const syntax::RectangleLit& written) {
    auto box = check_box(context_, expr, written);
    if (!box) return nullptr;
    ZoneExprPtr base = make(expr.range, std::move(box->base));
    return make(expr.range, ZonePrism{std::move(base), box->band.floor, box->band.ceiling});
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::ImportLit& written) {
    if (!is_alone(expr)) return nullptr;
    auto imported = import_zone(context_, written, frame_);
    return imported ? make(expr.range, std::move(*imported)) : nullptr;
  }

  bool is_alone(const syntax::Expr& expr) {
    const syntax::ImportOption* const scheduled = scheduled_in(expr);
    if (scheduled == nullptr || &expr == declared_) return true;
    context_.report(
        Finding(Code::zone_not_fixed, scheduled->range,
                "a zone with a schedule is there at certain times only")
            .label("a zone that stays as it is is due here")
            .help("declare it by itself, `zone closed = import \"...\" scheduled;`, and "
                  "judge places against it by its name: `p inside base and not p "
                  "inside closed`"));
    return false;
  }

  // `circle (0 m, 0 m) radius 1 m + 2 m`: a sum or product that begins with a circle.
  static bool computes_a_radius(const syntax::Binary& binary) {
    return std::holds_alternative<syntax::CircleLit>(binary.left->node) &&
           std::holds_alternative<syntax::NumberLit>(binary.right->node);
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::Binary& binary) {
    if (computes_a_radius(binary)) {
      return not_a_zone(expr, "a radius that is computed stands in brackets: `radius (2 * 1 m)`");
    }
    switch (binary.op) {
      case BinaryOp::zone_union:
        return join(expr, binary, ZoneOp::unite);
      case BinaryOp::zone_intersection:
        return join(expr, binary, ZoneOp::intersect);
      case BinaryOp::subtract:
        return join(expr, binary, ZoneOp::subtract);
      case BinaryOp::add:
      case BinaryOp::logical_or:
        return not_a_zone(expr, "zones are joined by `|`");
      case BinaryOp::multiply:
      case BinaryOp::logical_and:
        return not_a_zone(expr, "the common part of two zones is written with `&`");
      case BinaryOp::iff:
      case BinaryOp::implies:
      case BinaryOp::logical_xor:
      case BinaryOp::less:
      case BinaryOp::less_equal:
      case BinaryOp::greater:
      case BinaryOp::greater_equal:
      case BinaryOp::equal:
      case BinaryOp::not_equal:
      case BinaryOp::inside:
      case BinaryOp::divide:
        return not_a_zone(expr, zone_help);
    }
    return nullptr;
  }

  ZoneExprPtr join(const syntax::Expr& expr, const syntax::Binary& binary, ZoneOp op) {
    ZoneExprPtr left = check(*binary.left);
    ZoneExprPtr right = check(*binary.right);
    if (!left || !right) return nullptr;
    const ZonePair both{*binary.left, *binary.right, binary.op_range, "joined to"};
    if (!heights_agree(context_, both)) return nullptr;
    return make(expr.range, ZoneBinary{op, std::move(left), std::move(right)});
  }

  ZoneExprPtr zone(const syntax::Expr& expr, const syntax::Call& call) {
    if (!is_zone_function(call.callee.text)) return other_call(expr, call);
    if (call.callee.text == "complement") return complement(expr, call);
    const bool grows = call.callee.text == "grow";
    if (!argument_count(expr, call, 2, "a zone and a length are due", "(zone, 15 cm)")) {
      return nullptr;
    }
    ZoneExprPtr operand = check(*call.arguments[0]);
    const auto distance =
        quantity(context_, *call.arguments[1],
                 {dims::length, "the distance of `" + call.callee.text + "`", Limit::positive,
                  "a value of more than 0 works; `" + std::string(grows ? "shrink" : "grow") +
                      "` makes a zone " + (grows ? "smaller" : "larger")});
    if (!operand || !distance) return nullptr;
    return make(expr.range, ZoneOffset{std::move(operand),
                                       grows ? distance->value : Rational(-distance->value)});
  }

  bool argument_count(const syntax::Expr& expr, const syntax::Call& call, std::size_t due,
                      const std::string& label, const std::string& example) {
    if (call.arguments.size() == due) return true;
    context_.report(Finding(Code::wrong_argument_count, expr.range,
                            "`" + call.callee.text + "` takes " + std::to_string(due) +
                                (due == 1 ? " argument, not " : " arguments, not ") +
                                std::to_string(call.arguments.size()))
                        .label(label)
                        .help("write `" + call.callee.text + example + "`"));
    return false;
  }

  ZoneExprPtr complement(const syntax::Expr& expr, const syntax::Call& call) {
    if (!argument_count(expr, call, 1, "a zone is due", "(zone)")) return nullptr;
    const auto of =
        zone_in_property(context_, *call.arguments[0], frame_, Change::refused, Height::allowed);
    return of ? make(expr.range, ZoneComplement{*of}) : nullptr;
  }

  ZoneExprPtr other_call(const syntax::Expr& expr, const syntax::Call& call) {
    const std::string& name = call.callee.text;
    if (name == "leg" || name == "path") return way_as_zone(expr);
    if (name == "clearance" || name == "distance" || name == "energy_to" ||
        context_.symbols.find(name) != nullptr) {
      return not_a_zone(expr, zone_help);
    }
    if (context_.first_unknown(call.callee)) {
      context_.report(
          Finding(Code::unknown_function, call.callee.range, "there is no function `" + name + "`")
              .label("not a function")
              .help(did_you_mean(name, {"shrink", "grow", "complement"}, "functions of zones")));
    }
    return nullptr;
  }

  // How near a leg or a path is, is a distance.
  ZoneExprPtr way_as_zone(const syntax::Expr& expr) {
    const std::string way = print_expr(expr);
    context_.report(Finding(Code::zone_expected, expr.range, "a leg or a path is no zone")
                        .label("a zone is due here")
                        .help("write `distance(p, " + way + ") <= 1 m` for what stays near it, `" +
                              way + " inside Z` for where it leads"));
    return nullptr;
  }

  template <class Node>
  ZoneExprPtr zone(const syntax::Expr& expr, const Node&) {
    return not_a_zone(expr, zone_help);
  }

  ZoneExprPtr not_a_zone(const syntax::Expr& expr, const std::string& help) {
    const std::string form = form_of(expr);
    const bool known = !form.empty() && form != "a zone";
    context_.report(Finding(Code::zone_expected, expr.range, "a zone is due here")
                        .label(known ? "this is " + form : "this is not a zone")
                        .help(help));
    return nullptr;
  }

  static constexpr const char* zone_help =
      "write the name of a zone, `rectangle`, `circle`, `polygon`, `box`, `prism`, "
      "`shrink(zone, length)`, `complement(zone)`, `import \"file\"`, or zones joined by `|`, `&` "
      "and `-`";

  Context& context_;
  FrameId frame_;
  const syntax::Expr* declared_;
};

// When a declared zone is there: its windows, or those of its file.
std::vector<Opening> openings_of_zone(Context& context, const syntax::ZoneItem& written,
                                      const ZoneExprPtr& value) {
  const syntax::ImportOption* const scheduled = scheduled_in(*written.value);
  if (scheduled == nullptr) return check_openings(context, written.during);
  if (!written.during.empty()) {
    context.report(Finding(Code::duplicate_clause, written.during.front().range,
                           "the schedule of the file says when the zone is there")
                       .label("windows of time for a second time")
                       .note(scheduled->range, "the schedule is taken here")
                       .help("keep `scheduled`; or `during`, with `timeless \"why\"` behind the "
                             "file"));
  }
  const auto* const import = value ? std::get_if<ZoneImport>(&value->node) : nullptr;
  return import != nullptr ? import->openings : std::vector<Opening>{};
}

// The zone that an expression names, or is the complement of.
std::optional<ZoneId> referred(const ZoneExpr& expr) {
  if (const auto* reference = std::get_if<ZoneRef>(&expr.node)) return reference->zone;
  const auto* complement = std::get_if<ZoneComplement>(&expr.node);
  return complement != nullptr ? std::optional(complement->zone) : std::nullopt;
}

void collect_references(const ZoneExpr& expr, std::vector<const ZoneExpr*>& references) {
  if (referred(expr)) {
    references.push_back(&expr);
  } else if (const auto* binary = std::get_if<ZoneBinary>(&expr.node)) {
    collect_references(*binary->left, references);
    collect_references(*binary->right, references);
  } else if (const auto* offset = std::get_if<ZoneOffset>(&expr.node)) {
    collect_references(*offset->operand, references);
  } else if (const auto* prism = std::get_if<ZonePrism>(&expr.node)) {
    collect_references(*prism->base, references);
  }
}

// Depth-first search along references; every cycle is reported once, at its first zone.
class CycleSearch {
 public:
  explicit CycleSearch(Context& context)
      : context_(context), state_(context.spec.zones.size(), State::fresh) {}

  void visit(std::uint32_t zone) {
    if (state_[zone] != State::fresh) return;
    state_[zone] = State::open;
    path_.push_back(zone);
    std::vector<const ZoneExpr*> references;
    const Zone& declared = context_.spec.zones[zone];
    if (declared.value) collect_references(*declared.value, references);
    for (const ZoneExpr* reference : references) {
      const std::uint32_t next = index_of(*referred(*reference));
      if (state_[next] == State::open) report_cycle(next, *reference);
      visit(next);
    }
    path_.pop_back();
    state_[zone] = State::done;
  }

 private:
  enum class State { fresh, open, done };

  void report_cycle(std::uint32_t first, const ZoneExpr& closing) {
    const Zone& zone = context_.spec.zones[first];
    Finding finding(Code::zone_cycle, zone.name_range,
                    "the zone `" + zone.name + "` is defined by itself");
    finding.label("depends on itself");
    constexpr std::ptrdiff_t steps_max = 5;  // more would not help to find the way
    const auto begin = std::find(path_.begin(), path_.end(), first) + 1;
    const auto end = begin + std::min(path_.end() - begin, steps_max);
    for (auto step = begin; step != end; ++step) {
      const Zone& through = context_.spec.zones[*step];
      std::string text =
          through.name.empty() ? "by way of this zone" : "by way of `" + through.name + "`";
      if (step + 1 == end && end != path_.end()) {
        text += " and " + std::to_string(path_.end() - end) + " more";
      }
      finding.note(through.name_range, std::move(text));
    }
    finding.note(closing.range, "the circle closes here");
    finding.help("define one of these zones without the others");
    context_.report(finding);
  }

  Context& context_;
  std::vector<State> state_;
  std::vector<std::uint32_t> path_;
};

}  // namespace

bool is_zone_function(const std::string& name) {
  return name == "shrink" || name == "grow" || name == "complement";
}

std::optional<ZoneId> complemented(const Spec& spec, ZoneId zone) {
  // names that lead to one another in a circle are reported elsewhere
  for (std::size_t steps = 0; steps <= spec.zones.size(); ++steps) {
    const ZoneExpr* value = spec[zone].value.get();
    if (value == nullptr) return std::nullopt;
    const auto* complement = std::get_if<ZoneComplement>(&value->node);
    if (complement != nullptr) return complement->zone;
    const auto* name = std::get_if<ZoneRef>(&value->node);
    if (name == nullptr) return std::nullopt;
    zone = name->zone;
  }
  return std::nullopt;
}

void check_zones(Context& context) {
  for (std::size_t i = 0; i < context.zones.size(); ++i) {
    const auto frame = frame_of(context, context.zones[i].node->frame);
    context.spec.zones[i].frame = frame.value_or(map_frame);
  }
  for (std::size_t i = 0; i < context.zones.size(); ++i) {
    const syntax::Expr& written = *context.zones[i].node->value;
    ZoneChecker checker(context, context.spec.zones[i].frame, &written);
    // operands without a name join the zones meanwhile
    ZoneExprPtr value = checker.check(written);
    context.spec.zones[i].openings = openings_of_zone(context, *context.zones[i].node, value);
    context.spec.zones[i].value = std::move(value);
    context.spec.zones[i].has_height = has_height(context, written);
  }
  CycleSearch search(context);
  for (std::uint32_t i = 0; i < context.spec.zones.size(); ++i) search.visit(i);
}

namespace {

// `(1, 2)`: one mistake, not one for each coordinate.
bool have_units(Context& context, const syntax::PointLit& point, const SourceRange& range) {
  Finding finding(Code::unit_missing, range,
                  "the coordinates have no unit where lengths (m) are due");
  std::string mended;
  for (const syntax::ExprPtr& each : point.coordinates) {
    const syntax::Expr* number = bare_number(*each);
    if (number == nullptr) return true;
    const std::string sign = number == each.get() ? "" : "-";
    mended +=
        (mended.empty() ? "" : ", ") + sign + std::get<syntax::NumberLit>(number->node).text + " m";
    finding.insert_after(number->range, " m");
  }
  context.report(finding.label("a coordinate is a length (m)").help("write `(" + mended + ")`"));
  return false;
}

}  // namespace

namespace {

std::optional<std::vector<Rational>> coordinates(Context& context, const syntax::Expr& expr,
                                                 const std::string& what, bool space) {
  if (is_error(expr)) return std::nullopt;
  const auto* point = std::get_if<syntax::PointLit>(&expr.node);
  if (point == nullptr || point->coordinates.size() != (space ? 3 : 2)) {
    context.report(Finding(Code::point_expected, expr.range,
                           what + (space ? " is a point of space" : " is a point of the plane"))
                       .label(point == nullptr
                                  ? "not a point"
                                  : std::to_string(point->coordinates.size()) + " coordinates")
                       .help(space ? "write three lengths: `(1 m, 2 m, 3 m)`"
                                   : "write two lengths: `(1 m, 2 m)`"));
    return std::nullopt;
  }
  if (!have_units(context, *point, expr.range)) return std::nullopt;
  std::vector<Rational> values;
  for (const syntax::ExprPtr& each : point->coordinates) {
    const auto value = quantity(context, *each, {dims::length, "a coordinate"});
    if (value) values.push_back(value->value);
  }
  const bool good = values.size() == point->coordinates.size();
  return good ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace

std::optional<Point> check_point(Context& context, const syntax::Expr& expr,
                                 const std::string& what) {
  const auto found = coordinates(context, expr, what, false);
  return found ? std::optional(Point{(*found)[0], (*found)[1]}) : std::nullopt;
}
std::optional<std::vector<Rational>> check_corner(Context& context, const syntax::Expr& expr,
                                                  const std::string& what) {
  return coordinates(context, expr, what, true);
}

namespace {

// What asks for a zone without saying for which places.
constexpr const char* robots_are = "a robot";

bool lies_in_plane(Context& context, const syntax::Name& name, ZoneId id) {
  const std::uint32_t index = index_of(id);
  const bool is_written = index < context.zones.size();
  const bool tall = is_written ? has_height(context, *context.zones[index].node->value)
                               : context.spec[id].has_height;
  if (!tall) return true;
  if (is_written && height_is_open(context, *context.zones[index].node->value)) return false;
  report_height(context, name.range, "`" + name.text + "`", robots_are);
  return false;
}

bool stays(Context& context, const syntax::Name& name, ZoneId id, Change change) {
  const std::uint32_t index = index_of(id);
  if (index >= context.zones.size()) return true;
  const syntax::ZoneItem& written = *context.zones[index].node;
  const bool at_times = !written.during.empty() || scheduled_in(*written.value) != nullptr;
  const bool of_robot = change == Change::timed || change == Change::looked_ahead;
  const bool timed = of_robot || change == Change::apart || !at_times;
  if (!written.around && timed) return true;
  context.report(Finding(Code::zone_not_fixed, name.range,
                         "the zone `" + name.text + "` " +
                             (written.around ? "moves with `" + written.around->name.text + "`"
                                             : "is there at certain times only"))
                     .label("a zone that stays as it is is due here")
                     .note(context.spec[id].name_range, "`" + name.text + "` is declared here")
                     .help(of_robot ? "robots keep away from what moves by its distance: `forall q "
                                      ": Kind, q != r : distance(r, q) >= c` from other robots, "
                                      "`distance(r, agent) >= c` from an `agent`"
                                    : "monitors without a robot judge places against it by its "
                                      "name: `p inside base and not p inside " +
                                          name.text + "`" +
                                          (written.around ? ""
                                                          : ", and paths by `distance(plan, " +
                                                                name.text + ") > 0 m`")));
  return false;
}

}  // namespace

bool is_received_zone(const Context& context, const Symbol& symbol) {
  return symbol.sort == Sort::input && symbol.index < context.inputs.size() &&
         context.inputs[symbol.index].node->type.name.text == "zone";
}

// Zones are combined, grown and shrunk at compile time, and robots in space look ahead at what is
// known then.
static std::optional<ZoneId> received_zone(Context& context, const syntax::Name& name,
                                           const Symbol& symbol, Change change) {
  const InputId input{symbol.index};
  context.used_inputs.insert(input);
  if (change != Change::looked_ahead && change != Change::allowed) {
    context.report(Finding(Code::zone_not_fixed, name.range,
                           "the zone `" + name.text + "` is received while the monitors run")
                       .label("a zone that stays as it is is due here")
                       .note(symbol.range, "`" + name.text + "` is declared here")
                       .help("monitors without a robot judge places against it by its name: `p "
                             "inside base and not p inside " +
                             name.text + "`, and paths by `distance(plan, " + name.text +
                             ") > 0 m`"));
    return std::nullopt;
  }
  const auto zone = context.received_zones.find(input);
  return zone == context.received_zones.end() ? std::nullopt : std::optional(zone->second);
}

std::optional<ZoneId> zone_in_frame(Context& context, const syntax::Name& name, FrameId frame,
                                    Change change, Height height) {
  const Symbol* symbol = context.symbols.find(name.text);
  const bool received = symbol != nullptr && is_received_zone(context, *symbol);
  const auto id = received ? received_zone(context, name, *symbol, change)
                           : context.resolve<ZoneId>(name, Sort::zone);
  if (!id) return std::nullopt;
  if (change != Change::allowed && !stays(context, name, *id, change)) return std::nullopt;
  if (height == Height::refused && !lies_in_plane(context, name, *id)) return std::nullopt;
  if (context.spec[*id].frame == frame) return id;
  const std::string& here = context.spec[context.spec[*id].frame].name;
  const std::string& due = context.spec[frame].name;
  context.report(
      Finding(Code::frames_differ, name.range,
              "the zone `" + name.text + "` is in the frame `" + here + "`, `" + due + "` is due")
          .label("in `" + here + "`")
          .note(context.spec[*id].name_range, "`" + name.text + "` is declared here")
          .help("a zone stays in its frame: declare one in `" + due + "`, or bring points into `" +
                here + "` by `transform`"));
  return std::nullopt;
}

namespace {

// The first name of a zone; nullptr: none is named.
const Symbol* first_zone(const Context& context, const syntax::Expr& expr) {
  if (const auto* reference = std::get_if<syntax::NameRef>(&expr.node)) {
    const Symbol* symbol = context.symbols.find(reference->name.text);
    const bool is_zone =
        symbol != nullptr && (symbol->sort == Sort::zone || is_received_zone(context, *symbol));
    return is_zone ? symbol : nullptr;
  }
  if (const auto* binary = std::get_if<syntax::Binary>(&expr.node)) {
    const Symbol* left = first_zone(context, *binary->left);
    return left != nullptr ? left : first_zone(context, *binary->right);
  }
  const auto* call = std::get_if<syntax::Call>(&expr.node);
  if (call != nullptr && !call->arguments.empty()) {
    return first_zone(context, *call->arguments.front());
  }
  const auto* prism = std::get_if<syntax::PrismLit>(&expr.node);
  return prism != nullptr ? first_zone(context, *prism->base) : nullptr;
}

}  // namespace

FrameId frame_of_zone(const Context& context, const syntax::Expr& expr) {
  const Symbol* zone = first_zone(context, expr);
  if (zone == nullptr) return map_frame;
  if (zone->sort == Sort::zone) return context.spec[ZoneId{zone->index}].frame;
  return zone->index < context.input_types.size() ? context.input_types[zone->index].frame
                                                  : map_frame;
}

ZoneId complement_of(Context& context, ZoneId zone, const SourceRange& range) {
  if (const auto of = complemented(context.spec, zone)) return *of;
  auto& zones = context.spec.zones;
  const auto same = std::find_if(zones.begin(), zones.end(), [&](const Zone& each) {
    const auto* of = each.value ? std::get_if<ZoneComplement>(&each.value->node) : nullptr;
    return each.name.empty() && of != nullptr && of->zone == zone;
  });
  if (same != zones.end()) return ZoneId{static_cast<std::uint32_t>(same - zones.begin())};
  const Zone& of = context.spec[zone];
  Zone complement{"", range, std::make_unique<ZoneExpr>(ZoneExpr{range, ZoneComplement{zone}}),
                  of.frame, of.has_height};
  zones.push_back(std::move(complement));
  return ZoneId{static_cast<std::uint32_t>(zones.size() - 1)};
}

std::optional<ZoneId> zone_in_property(Context& context, const syntax::Expr& expr, FrameId frame,
                                       Change change, Height height) {
  if (const auto* reference = std::get_if<syntax::NameRef>(&expr.node)) {
    return zone_in_frame(context, reference->name, frame, change, height);
  }
  if (height == Height::refused && !lies_in_plane(context, expr, robots_are)) return std::nullopt;
  // the body of a function is looked at for each of its calls
  auto& zones = context.spec.zones;
  const auto same = std::find_if(zones.begin(), zones.end(), [&](const Zone& zone) {
    return zone.name.empty() && zone.value && zone.frame == frame && zone.name_range == expr.range;
  });
  if (same != zones.end()) return ZoneId{static_cast<std::uint32_t>(same - zones.begin())};
  ZoneExprPtr value = ZoneChecker(context, frame).check(expr);
  if (!value) return std::nullopt;
  context.spec.zones.push_back(
      {"", expr.range, std::move(value), frame, has_height(context, expr)});
  return ZoneId{static_cast<std::uint32_t>(context.spec.zones.size() - 1)};
}

}  // namespace rtac::sema
