#include "compiler/verify/aside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/analysis/standoffs.h"
#include "compiler/verify/centres.h"
#include "compiler/verify/in_space.h"

namespace rtac::verify {
namespace {

using analysis::outline::Outline;
using analysis::outline::P;
using geometry::Region;

constexpr int places_across = 40;
// Around what is written down, for what lies outside of it.
constexpr double around_mm = 5'000;

double between(const At& a, const At& b) {
  return std::hypot(analysis::outline::norm(a.p - b.p), a.z - b.z);
}

// Of a grid, and corners, as a narrow region may have no other places.
std::vector<At> in_the_plane(const Subject& s, const std::vector<At>& begins,
                             std::int64_t spare_mm) {
  Region holds = Region::everywhere();
  for (const ir::Monitor& m : s.decision.monitors) {
    holds = holds.intersect(centres_of(s, m, spare_mm));
  }
  if (holds.empty()) return {};
  const Outline outline = Outline::of(holds);
  P low = begins.front().p, high = low;
  const auto reach = [&](P p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  };
  for (const At& at : begins) reach(at.p);
  std::vector<At> all;
  for (const auto& edge : outline.edges()) {
    all.push_back({edge.a});
    reach(edge.a);
  }
  low = low - P{around_mm, around_mm};
  high = high + P{around_mm, around_mm};
  for (int n = 0; n < places_across * places_across; ++n) {
    const int column = n % places_across, row = n / places_across;
    const P p{low.x + (column + 0.5) / places_across * (high.x - low.x),
              low.y + (row + 0.5) / places_across * (high.y - low.y)};
    if (outline.edges().empty() || outline.contains(p)) all.push_back({p});
  }
  return all;
}

std::vector<At> in_space(const Subject& s, double spare_mm) {
  const double body_mm = double(s.decision.body.radius_mm);
  std::vector<Says> says;
  for (const ir::Monitor& m : s.decision.monitors) says.push_back(says_of(s, m.property));
  std::vector<At> all = grid_of(says, body_mm, body_mm + spare_mm);
  std::erase_if(all, [&](const At& at) {
    return !std::ranges::all_of(
        says, [&](const Says& each) { return each.holds(at, body_mm, spare_mm); });
  });
  return all;
}

// As far from each other, and from those that have their places, as there is room; all of them, or
// as many as there is room for.
std::vector<At> spread(const std::vector<At>& free, const std::vector<At>& taken, std::size_t count,
                       double least_mm) {
  // how far each is from all that are taken
  std::vector<double> away(free.size(), std::numeric_limits<double>::infinity());
  const auto keep_off = [&](const At& other) {
    for (std::size_t i = 0; i < free.size(); ++i) {
      away[i] = std::min(away[i], between(free[i], other));
    }
  };
  for (const At& at : taken) keep_off(at);
  std::vector<At> found;
  while (found.size() < count) {
    const auto farthest = std::ranges::max_element(away);
    if (farthest == away.end() || *farthest < least_mm) break;
    found.push_back(free[static_cast<std::size_t>(farthest - away.begin())]);
    keep_off(found.back());
  }
  return found;
}

}  // namespace

std::vector<std::vector<std::int64_t>> aside_of(
    const Subject& s, const std::vector<std::vector<std::int64_t>>& begins) {
  if (s.decision.robots < 2 || begins.empty()) return {};
  std::vector<At> taken;
  for (const auto& mm : begins) {
    taken.push_back({{double(mm[0]), double(mm[1])}, mm.size() > 2 ? double(mm[2]) : 0});
  }
  const auto count = static_cast<std::size_t>(s.decision.robots - 1);
  const double apart_mm =
      double(2 * s.decision.body.radius_mm + analysis::standoffs_of(s.decision).separation_mm);
  const bool space = s.decision.body.in_space;
  std::vector<At> found;
  for (const std::int64_t spare_mm : {s.decision.standing_mm, start_spare_mm, std::int64_t{0}}) {
    found = spread(space ? in_space(s, double(spare_mm)) : in_the_plane(s, taken, spare_mm), taken,
                   count, apart_mm + 2 * double(spare_mm));
    if (found.size() == count) break;
  }
  std::vector<std::vector<std::int64_t>> aside;
  for (const At& at : found) {
    aside.push_back({std::llround(at.p.x), std::llround(at.p.y)});
    if (space) aside.back().push_back(std::llround(at.z));
  }
  return aside;
}

}  // namespace rtac::verify
