#include "compiler/geometry/united.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/geometry/ring.h"
#include "compiler/geometry/runs.h"
#include "compiler/geometry/sweep.h"

namespace rtac::geometry {
namespace {

using Rings = std::vector<Ring>;

// Lists of rings in any order that tells equal ones.
bool before(const Rings& a, const Rings& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(), [](const Ring& r, const Ring& s) {
        return std::lexicographical_compare(
            r.begin(), r.end(), s.begin(), s.end(),
            [](const Point& p, const Point& q) { return lower_left(p, q); });
      });
}

bool is_end(const Point& p, const Edge& e) {
  return same(p, *e.a) || same(p, *e.b);
}

// The boundaries of all regions, region by region.
class Boundaries {
 public:
  explicit Boundaries(const std::vector<Rings>& regions) : edges_(all_rings(regions)) {
    std::size_t ring = 0;
    for (const Rings& region : regions) {
      const std::size_t from = edges_.first(ring);
      ring += region.size();
      starts_.push_back(from);
      runs_.emplace_back(edges_, from, edges_.first(ring));
    }
    starts_.push_back(edges_.first(ring));
  }

  [[nodiscard]] bool cross_too_often() {
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      for (std::size_t s = 0; s < r; ++s) {
        if (!runs_[r].apart(runs_[s]) && !count(r, s)) return true;
      }
    }
    return false;
  }

 private:
  static std::vector<const Ring*> all_rings(const std::vector<Rings>& regions) {
    std::vector<const Ring*> all;
    for (const Rings& region : regions) {
      for (const Ring& ring : region) all.push_back(&ring);
    }
    return all;
  }
  // False: too often by now.
  bool count(std::size_t r, std::size_t s) {
    constexpr std::size_t crossing = touches_max / crossings_max;
    for (std::size_t i = starts_[r]; i < starts_[r + 1]; ++i) {
      const Edge& e = edges_[i];
      if (runs_[s].apart(e)) continue;
      const bool few = runs_[s].for_each_meeting(e, [&](const Edge& f, const Point& at) {
        cost_ += is_end(at, e) || is_end(at, f) ? 1 : crossing;
        return cost_ <= touches_max;
      });
      if (!few) return false;
    }
    return true;
  }

  Edges edges_;
  std::vector<std::size_t> starts_;  // of the edges of each region, and their end
  std::vector<Runs> runs_;
  std::size_t cost_ = 0;
};

std::vector<Rings> different(const std::vector<Region>& regions) {
  std::vector<Rings> all;
  for (const Region& region : regions) all.push_back(region.rings());
  std::sort(all.begin(), all.end(), before);
  const auto equal = [](const Rings& a, const Rings& b) { return !before(a, b) && !before(b, a); };
  all.erase(std::unique(all.begin(), all.end(), equal), all.end());
  return all;
}

bool cross_too_often(const std::vector<Rings>& regions) {
  return regions.size() > 1 && Boundaries(regions).cross_too_often();
}

}  // namespace

bool cross_too_often(const std::vector<Region>& regions) {
  return cross_too_often(different(regions));
}

std::optional<Region> united(std::vector<Region> regions) {
  if (regions.size() == 1) return std::move(regions[0]);
  std::vector<Rings> parts = different(regions);
  if (cross_too_often(parts)) return std::nullopt;
  Rings all;
  for (Rings& rings : parts) std::move(rings.begin(), rings.end(), std::back_inserter(all));
  return Region::of_rings(all);
}

}  // namespace rtac::geometry
