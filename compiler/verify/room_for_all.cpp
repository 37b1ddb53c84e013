#include "compiler/verify/room_for_all.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/verify/common_place.h"

namespace rtac::verify {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

geometry::Point place(double x_mm, double y_mm) {
  return {analysis::metres_of(static_cast<std::int64_t>(x_mm)),
          analysis::metres_of(static_cast<std::int64_t>(y_mm))};
}

// How many lines a net has each way: at each knot every corner of the zones is looked at.
int lines_for(const Subject& s, const std::vector<Need>& all) {
  constexpr double looks_max = 200'000;
  std::size_t corners = 1;
  for (const Need& need : all) corners += s.exact(need.zone).vertices();
  return static_cast<int>(
      std::clamp(std::sqrt(looks_max / static_cast<double>(corners)), 12.0, 64.0));
}

// From the first to the last whole millimetre of a side.
struct Side {
  double low = infinite, high = -infinite;
  void take(const Rational& m) {
    low = std::min(low, m.get_d() * 1000), high = std::max(high, m.get_d() * 1000);
  }
  [[nodiscard]] double at(int line, int lines) const {
    return std::clamp(std::round(low + (high - low) * line / lines), std::ceil(low),
                      std::floor(high));
  }
};

}  // namespace

std::int64_t centres_apart_mm(const Subject& s) {
  const std::int64_t separation_mm = analysis::sure_separation_mm(s.decision);
  return separation_mm > 0 ? separation_mm + 2 * s.decision.body.radius_mm : 0;
}

// A net over what is left of the zones.
RoomForAll::RoomForAll(const Subject& s, const std::vector<Need>& all)
    : robots_(static_cast<std::size_t>(s.decision.robots)) {
  geometry::Region common = geometry::Region::everywhere();
  for (const Need& need : all) {
    const auto deep = analysis::within(s.exact(need.zone), need.clearance_mm);
    if (!deep) return;
    common = common.intersect(*deep);
  }
  Side across, up;
  for (const geometry::Ring& ring : common.rings()) {
    for (const geometry::Point& p : ring) across.take(p.x), up.take(p.y);
  }
  if (across.low > across.high) return;
  const int lines = lines_for(s, all);
  for (int row = 0; row <= lines; ++row) {
    for (int column = 0; column <= lines; ++column) {
      const Spot at{across.at(column, lines), up.at(row, lines)};
      if (is_clear(s, all, place(at.x, at.y))) by_row_.push_back(at);
    }
  }
  by_column_ = by_row_;
  std::ranges::sort(
      by_column_, [](const Spot& a, const Spot& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
}

double RoomForAll::square(const Spot& a, const Spot& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// Each place that is far enough from those before it.
RoomForAll::Spots RoomForAll::one_by_one(const Spots& net, double apart_mm) const {
  Spots taken;
  for (const Spot& at : net) {
    if (taken.size() == robots_) break;
    const bool far = std::ranges::all_of(
        taken, [&](const Spot& other) { return square(at, other) >= apart_mm * apart_mm; });
    if (far) taken.push_back(at);
  }
  return taken;
}

// From one place on, always the one that is farthest from all before it.
RoomForAll::Spots RoomForAll::farthest_first(std::size_t first, double apart_mm) const {
  Spots taken{by_row_[first]};
  std::vector<double> nearest(by_row_.size(), infinite);
  while (taken.size() < robots_) {
    for (std::size_t k = 0; k < by_row_.size(); ++k) {
      nearest[k] = std::min(nearest[k], square(by_row_[k], taken.back()));
    }
    const auto next = std::ranges::max_element(nearest);
    if (*next < apart_mm * apart_mm) break;
    taken.push_back(by_row_[static_cast<std::size_t>(next - nearest.begin())]);
  }
  return taken;
}

// What is found last may be too few.
RoomForAll::Spots RoomForAll::found(double apart_mm) const {
  if (by_row_.empty()) return {};
  Spots best = one_by_one(by_row_, apart_mm);
  if (best.size() < robots_) best = one_by_one(by_column_, apart_mm);
  constexpr std::size_t firsts = 8;  // spread over the rows
  for (std::size_t k = 0; k < firsts && best.size() < robots_; ++k) {
    best = farthest_first(k * (by_row_.size() - 1) / (firsts - 1), apart_mm);
  }
  return best;
}

std::optional<std::vector<geometry::Point>> RoomForAll::centres(std::int64_t apart_mm) const {
  const Spots spots = found(static_cast<double>(apart_mm));
  if (spots.size() < robots_) return std::nullopt;
  std::vector<geometry::Point> centres;
  std::ranges::transform(spots, std::back_inserter(centres),
                         [](const Spot& at) { return place(at.x, at.y); });
  return centres;
}

std::optional<std::int64_t> RoomForAll::most_apart_mm(std::int64_t below_mm) const {
  std::int64_t low = 1, high = below_mm;
  if (!centres(low)) return std::nullopt;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (centres(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace rtac::verify
