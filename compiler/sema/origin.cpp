#include "compiler/sema/origin.h"

#include <cmath>

#include "compiler/sema/quantity.h"
#include "compiler/sema/units.h"

namespace rtac::sema {

namespace {

Rational degree() {
  return parse_unit("deg")->factor;
}

class OriginChecker {
 public:
  explicit OriginChecker(Context& context) : context_(context) {}

  void check(const SourceRange& range, const syntax::OriginItem& written) {
    if (first_) {
      context_.duplicate_clause(range, *first_, "`origin`");
      return;
    }
    first_ = range;
    context_.origin_written = true;
    const auto& values = written.values;
    for (const syntax::ExprPtr& value : values) {
      if (is_error(*value)) return;
    }
    if (values.size() < 2 || values.size() > 3) {
      context_.report(Finding(Code::wrong_argument_count, range,
                              "`origin` takes a latitude, a longitude and perhaps an altitude")
                          .label(std::to_string(values.size()) + " given")
                          .help("write `origin 47.3977 deg, 8.5456 deg;`, or with the altitude "
                                "above mean sea level `origin 47.3977 deg, 8.5456 deg, 432 m;`"));
      return;
    }
    if (by_the_compass(values)) return;
    const auto latitude = angle(*values[0], "the latitude of the origin", latitude_max);
    const auto longitude = angle(*values[1], "the longitude of the origin", longitude_max);
    std::optional<Quantity> altitude;
    if (values.size() == 3) {
      altitude = height(*values[2]);
      if (!altitude) return;
    }
    if (latitude && longitude) context_.spec.origin = Origin{*latitude, *longitude, altitude};
  }

 private:
  // `47.4 N`: as maps are lettered.
  bool by_the_compass(const std::vector<syntax::ExprPtr>& values) {
    std::string places;
    bool lettered = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto* number = std::get_if<syntax::NumberLit>(&values[k]->node);
      if (number == nullptr || !number->unit) return false;
      const std::string& letter = number->unit->text;
      const bool down = letter == "S" || letter == "W";
      if (!down && letter != "N" && letter != "E" && letter != "deg") return false;
      lettered = lettered || letter != "deg";
      places += (places.empty() ? "" : ", ") + std::string(down ? "-" : "") + number->text + " deg";
    }
    if (!lettered) return false;
    const SourceRange both{values[0]->range.file, values[0]->range.begin, values[1]->range.end};
    context_.report(Finding(Code::wrong_dimension, both, "the angles of `origin` are in degrees")
                        .label("letters of the compass are no unit")
                        .help("write `origin " + places +
                              ";`: north and east count up, south and west have a minus")
                        .replace(both, places));
    return true;
  }

  static constexpr int latitude_max = static_cast<int>(geometry::latitude_deg_max);
  static constexpr int longitude_max = 180;
  // Of ground in m, with room: the shore of the Dead Sea lies at -440 m, Mount Everest at 8,849 m.
  static constexpr int altitude_min = -500, altitude_max = 10'000;

  std::optional<Quantity> height(const syntax::Expr& expr) {
    const auto value = quantity(context_, expr, {dims::length, "the altitude of the origin"});
    if (!value || (value->value >= altitude_min && value->value <= altitude_max)) return value;
    context_.report(
        Finding(Code::quantity_out_of_range, expr.range,
                "the altitude of the origin cannot be " + to_decimal(value->value) + " m")
            .label("above mean sea level")
            .help(std::to_string(altitude_min) + " m to " + std::to_string(altitude_max) +
                  " m work"));
    return std::nullopt;
  }

  std::optional<Quantity> angle(const syntax::Expr& expr, const std::string& what, int limit) {
    const auto value = quantity(context_, expr, {dims::angle, what});
    if (!value) return std::nullopt;
    if (abs(value->value) <= limit * degree()) return value;
    const std::string most = std::to_string(limit) + " deg";
    context_.report(
        Finding(Code::quantity_out_of_range, expr.range,
                what + " cannot be " + to_decimal(Rational(value->value / degree())) + " deg")
            .label("beyond " + most)
            .help("-" + most + " to " + most +
                  " work; the latitude comes first, then the longitude"));
    return std::nullopt;
  }

  Context& context_;
  std::optional<SourceRange> first_;
};

double nearest_double(const Rational& value) {
  const double below = value.get_d();  // towards 0
  const double above = std::nextafter(below, sgn(value) < 0 ? -1e300 : 1e300);
  return abs(Rational(value - Rational(below))) <= abs(Rational(value - Rational(above))) ? below
                                                                                          : above;
}

}  // namespace

void check_origin(Context& context, const syntax::Program& program) {
  OriginChecker checker(context);
  for (const syntax::File& file : program.files) {
    for (const syntax::Item& item : file.items) {
      const auto* written = std::get_if<syntax::OriginItem>(&item.node);
      if (written != nullptr) checker.check(item.range, *written);
    }
  }
}

geometry::Origin in_degrees(const Origin& origin) {
  return {nearest_double(Rational(origin.latitude.value / degree())),
          nearest_double(Rational(origin.longitude.value / degree()))};
}

}  // namespace rtac::sema
