#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "compiler/geometry/import/areas.h"
#include "tests/fuzz/subjects.h"

namespace rtac::fuzz {
namespace {

namespace import = geometry::import;

std::string judge_failure(const import::Failure& failure) {
  if (failure.where.empty() || failure.message.empty() || failure.help.empty()) {
    return "a failure lacks its place, its message or its help";
  }
  // Quotations are cut, and paths have at most 64 steps.
  const std::size_t longest = 8192;
  if (failure.where.size() + failure.message.size() > longest) return "a failure is too long";
  return {};
}

bool is_on_earth(import::Position position, const import::Areas& areas) {
  if (!std::isfinite(position.x) || !std::isfinite(position.y)) return false;
  if (areas.unit != import::Unit::degrees) return true;
  if (areas.only_turned) std::swap(position.x, position.y);
  const double longest = areas.axes == import::Axes::unstated ? 180 : 90;
  return std::abs(position.x) <= 180 && std::abs(position.y) <= longest;
}

bool is_ring(const import::Ring& ring, const import::Areas& areas) {
  return ring.positions.size() >= 3 && !ring.where.empty() &&
         std::all_of(ring.positions.begin(), ring.positions.end(),
                     [&](import::Position position) { return is_on_earth(position, areas); });
}

std::string judge_part(const import::Part& part, const import::Areas& areas) {
  if (const auto* circle = std::get_if<import::Circle>(&part.shape)) {
    const bool is_good = circle->radius_m > 0 && std::isfinite(circle->radius_m) &&
                         is_on_earth(circle->centre, areas) && !circle->where.empty();
    if (!is_good) return "a circle is none";
  } else {
    const auto& polygon = std::get<import::Polygon>(part.shape);
    const bool is_good =
        is_ring(polygon.outer, areas) &&
        std::all_of(polygon.holes.begin(), polygon.holes.end(),
                    [&](const import::Ring& hole) { return is_ring(hole, areas); });
    if (!is_good) return "a ring is none";
  }
  const auto& [floor, ceiling] = part.band;
  if (floor && ceiling && floor->reference == ceiling->reference &&
      floor->value_m > ceiling->value_m) {
    return "a band is upside down";
  }
  return {};
}

std::string judge_area(const import::Area& area, const import::Areas& areas) {
  if (area.where.empty()) return "an area has no place";
  if (area.refusal.has_value() != area.parts.empty()) return "neither refused nor of parts";
  if (area.refusal) return judge_failure(*area.refusal);
  for (const import::Part& part : area.parts) {
    if (std::string problem = judge_part(part, areas); !problem.empty()) return problem;
  }
  for (const import::Period& period : area.schedule) {
    if (period.from_s < 0 || period.from_s >= period.until_s || period.until_s > 86'400 ||
        period.weekdays == 0 || period.weekdays > 0x7f) {
      return "a period is none";
    }
  }
  return {};
}

std::string judge(const std::variant<import::Areas, import::Failure>& outcome) {
  if (const auto* failure = std::get_if<import::Failure>(&outcome)) return judge_failure(*failure);
  const auto& areas = std::get<import::Areas>(outcome);
  if (areas.areas.empty()) return "a file of nothing was read";
  for (const import::Area& area : areas.areas) {
    if (std::string problem = judge_area(area, areas); !problem.empty()) return problem;
  }
  for (const import::Note& note : areas.notes) {
    if (note.where.empty() || note.message.empty()) return "a note lacks its place";
  }
  return {};
}

}  // namespace

std::string run_zones(std::string_view text) {
  using import::Format;
  const std::string content(text);
  import::format_of("zones", content);
  for (const Format format : {Format::geojson, Format::wkt, Format::kml, Format::qgc_plan,
                              Format::waypoints, Format::ed269, Format::ed318}) {
    if (std::string problem = judge(import::read(format, content, {})); !problem.empty()) {
      return problem;
    }
  }
  return {};
}

}  // namespace rtac::fuzz
