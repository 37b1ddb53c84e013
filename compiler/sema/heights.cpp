#include "compiler/sema/heights.h"

#include <algorithm>
#include <set>

#include "compiler/sema/quantity.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {
namespace {

bool has_coordinates(const syntax::Expr& corner, std::size_t count) {
  const auto* point = std::get_if<syntax::PointLit>(&corner.node);
  return point != nullptr && point->coordinates.size() == count;
}

class HeightFinder {
 public:
  explicit HeightFinder(const Context& context) : context_(context) {}

  bool of(const syntax::Expr& expr) {
    return std::visit([&](const auto& node) { return zone(node); }, expr.node);
  }
  [[nodiscard]] bool is_open() const { return is_open_; }

 private:
  bool zone(const syntax::PrismLit&) { return true; }
  bool zone(const syntax::RectangleLit& box) {
    if (box.says_box) {
      is_open_ = is_open_ || has_coordinates(*box.from, 2) || has_coordinates(*box.to, 2);
      return true;
    }
    const bool from = has_coordinates(*box.from, 3), to = has_coordinates(*box.to, 3);
    is_open_ = is_open_ || from != to;
    return from || to;
  }
  bool zone(const syntax::ImportLit& file) {
    return std::ranges::any_of(file.options, [](const syntax::ImportOption& option) {
      return option.word == syntax::ImportWord::heights;
    });
  }
  bool zone(const syntax::Binary& joined) {
    const bool left = of(*joined.left);
    return of(*joined.right) || left;
  }
  bool zone(const syntax::Call& call) {
    return is_zone_function(call.callee.text) && !call.arguments.empty() &&
           of(*call.arguments.front());
  }
  bool zone(const syntax::NameRef& reference) {
    const Symbol* symbol = context_.symbols.find(reference.name.text);
    const bool is_new = symbol != nullptr && symbol->sort == Sort::zone &&
                        symbol->index < context_.zones.size() &&
                        visited_.insert(symbol->index).second;
    return is_new && of(*context_.zones[symbol->index].node->value);
  }
  template <class Other>
  bool zone(const Other&) {
    return false;
  }

  const Context& context_;
  bool is_open_ = false;             // corners do not say what the zone is to have
  std::set<std::uint32_t> visited_;  // names may lead to themselves, which is reported elsewhere
};

// "`pond`", "the zone".
std::string called(const syntax::Expr& expr) {
  const auto* reference = std::get_if<syntax::NameRef>(&expr.node);
  return reference != nullptr ? "`" + reference->name.text + "`" : "the zone";
}

std::string metres(const Rational& value) {
  return show(value, dims::length);
}

}  // namespace

bool has_height(const Context& context, const syntax::Expr& expr) {
  return HeightFinder(context).of(expr);
}

bool height_is_open(const Context& context, const syntax::Expr& expr) {
  HeightFinder finder(context);
  finder.of(expr);
  return finder.is_open();
}

bool lies_in_plane(Context& context, const syntax::Expr& expr, const std::string& due) {
  if (!has_height(context, expr)) return true;
  if (height_is_open(context, expr)) return false;
  report_height(context, expr.range, called(expr), due);
  return false;
}

void report_height(Context& context, const SourceRange& range, const std::string& zone,
                   const std::string& due) {
  context.report(
      Finding(Code::spaces_differ, range, zone + " has height, " + due + " has none")
          .label("a zone of the plane is due here")
          .help("write a zone of the plane, without `box` and `prism`; robots whose position is a "
                "`point3` "
                "are judged in zones with height, and inputs of that type by monitors without a "
                "robot"));
}

bool heights_agree(Context& context, const ZonePair& pair) {
  const bool left = has_height(context, pair.left), right = has_height(context, pair.right);
  if (left == right) return true;
  const syntax::Expr& flat = left ? pair.right : pair.left;
  const syntax::Expr& tall = left ? pair.left : pair.right;
  if (height_is_open(context, tall)) return false;
  const auto* name = std::get_if<syntax::NameRef>(&flat.node);
  const std::string base = name != nullptr ? name->name.text : "...";
  context.report(
      Finding(Code::spaces_differ, pair.where,
              "a zone with height is " + pair.verb + " one of the plane")
          .label("how high the other one reaches is not said")
          .note(flat.range, called(flat) + " lies in the plane")
          .note(tall.range, called(tall) + " has height")
          .help("say from where to where it reaches: `prism (" + base + ") from 0 m to 50 m`"));
  return false;
}

std::optional<Band> check_band(Context& context, const syntax::Expr& expr,
                               const syntax::PrismLit& prism) {
  const auto floor = quantity(context, *prism.floor, {dims::length, "the floor of a prism"});
  const auto ceiling = quantity(context, *prism.ceiling, {dims::length, "the ceiling of a prism"});
  if (!floor || !ceiling) return std::nullopt;
  if (floor->value < ceiling->value) return Band{floor->value, ceiling->value};
  const bool flat = floor->value == ceiling->value;
  Finding finding(Code::band_inverted, expr.range,
                  flat ? "the prism has no height: floor and ceiling are at " + metres(floor->value)
                       : "the prism is upside down: its floor is at " + metres(floor->value) +
                             ", its ceiling at " + metres(ceiling->value));
  finding.label(flat ? "no height" : "the floor is above the ceiling");
  finding.help(flat ? "give it two different heights, the lower one first"
                    : "the lower height stands first: `from " + metres(ceiling->value) + " to " +
                          metres(floor->value) + "`");
  context.report(finding);
  return std::nullopt;
}

namespace {

// `box (0 m, 0 m) to (5 m, 5 m)`: one mistake, not one for each corner.
bool has_depth(Context& context, const syntax::Expr& expr, const syntax::RectangleLit& box) {
  if (!box.says_box || !has_coordinates(*box.from, 2) || !has_coordinates(*box.to, 2)) {
    return true;
  }
  SourceRange word = expr.range;
  word.end = word.begin + 3;
  context.report(Finding(Code::point_expected, expr.range, "a box has corners in space")
                     .label("corners of the plane")
                     .help("write three lengths, `(1 m, 2 m, 3 m)`, or `rectangle` for a zone of "
                           "the plane")
                     .replace(word, "rectangle"));
  return false;
}

}  // namespace

std::optional<CheckedBox> check_box(Context& context, const syntax::Expr& expr,
                                    const syntax::RectangleLit& box) {
  if (!has_depth(context, expr, box)) return std::nullopt;
  const auto from = check_corner(context, *box.from, "a corner of a box");
  const auto to = check_corner(context, *box.to, "a corner of a box");
  if (!from || !to) return std::nullopt;
  for (std::size_t axis = 0; axis < from->size(); ++axis) {
    if ((*from)[axis] != (*to)[axis]) continue;
    context.report(Finding(Code::rectangle_degenerate, expr.range,
                           std::string("the box has no volume: both corners have ") + "xyz"[axis] +
                               " = " + metres((*from)[axis]))
                       .label("no volume")
                       .help("give two corners that differ in all three coordinates"));
    return std::nullopt;
  }
  const auto [left, right] = std::minmax((*from)[0], (*to)[0]);
  const auto [bottom, top] = std::minmax((*from)[1], (*to)[1]);
  const auto [floor, ceiling] = std::minmax((*from)[2], (*to)[2]);
  CheckedBox checked;
  checked.base.outer.points = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  checked.base.outer.range = expr.range;
  checked.base.outer.point_ranges.assign(4, expr.range);
  checked.band = {floor, ceiling};
  return checked;
}

}  // namespace rtac::sema
