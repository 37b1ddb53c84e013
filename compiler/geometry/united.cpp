#include "compiler/geometry/united.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/geometry/ring.h"
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
bool share_an_end(const Edge& e, const Edge& f) {
  return e.rank_a == f.rank_a || e.rank_a == f.rank_b || e.rank_b == f.rank_a ||
         e.rank_b == f.rank_b;
}

Bounds around(const Bounds& a, const Bounds& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}
double length(const Bounds& b) {
  return b.hi - b.lo;
}

// The boundaries of all regions, region by region.
class Boundaries {
 public:
  explicit Boundaries(const std::vector<Rings>& regions) : edges_(all_rings(regions)) {
    std::size_t ring = 0;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      for (std::size_t end = ring + regions[r].size(); ring < end; ++ring) add_boxes(r, ring);
    }
  }

  [[nodiscard]] std::size_t cost() {
    if (boxes_.empty()) return 0;
    const std::size_t last = edges_.rings() - 1;
    if (!sweep(edges_, 0, edges_.first(last) + edges_.size(last)).meet) return 0;
    sort();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Box& a = boxes_[i];
      for (std::size_t j = i + 1; j < boxes_.size() && boxes_[j].x.lo <= a.x.hi; ++j) {
        ++looks_;
        const Box& b = boxes_[j];
        if (a.region == b.region || disjoint(a.y, b.y)) continue;
        if (!count(a, b)) return touches_max + 1;
      }
    }
    return cost_;
  }

 private:
  // Edges of one ring that follow each other. `x` is the direction that boxes are sorted in.
  struct Box {
    std::size_t from, to, region;
    Bounds x, y;
  };
  static constexpr std::size_t box_size = 32;

  static std::vector<const Ring*> all_rings(const std::vector<Rings>& regions) {
    std::vector<const Ring*> all;
    for (const Rings& region : regions) {
      for (const Ring& ring : region) all.push_back(&ring);
    }
    return all;
  }
  void add_boxes(std::size_t region, std::size_t ring) {
    const std::size_t end = edges_.first(ring) + edges_.size(ring);
    for (std::size_t from = edges_.first(ring); from < end; from += box_size) {
      Box box{from, std::min(from + box_size, end), region, edges_[from].x, edges_[from].y};
      for (std::size_t i = from; i < box.to; ++i) {
        box.x = around(box.x, edges_[i].x);
        box.y = around(box.y, edges_[i].y);
      }
      boxes_.push_back(box);
    }
  }
  // In the direction in which fewer boxes overlap.
  void sort() {
    Box all = boxes_.front();
    double x = 0, y = 0;
    for (const Box& box : boxes_) {
      all.x = around(all.x, box.x);
      all.y = around(all.y, box.y);
      x += length(box.x);
      y += length(box.y);
    }
    if (y * length(all.x) < x * length(all.y)) {
      for (Box& box : boxes_) std::swap(box.x, box.y);
      turned_ = true;
    }
    std::ranges::sort(boxes_, [](const Box& a, const Box& b) {
      return a.x.lo != b.x.lo ? a.x.lo < b.x.lo : a.from < b.from;
    });
  }
  [[nodiscard]] bool apart(const Edge& e, const Box& box) const {
    const bool by_x = disjoint(e.x, turned_ ? box.y : box.x);
    return by_x || disjoint(e.y, turned_ ? box.x : box.y);
  }
  // False: too often by now.
  bool count(const Box& a, const Box& b) {
    for (std::size_t i = a.from; i < a.to; ++i) {
      if (apart(edges_[i], b)) continue;
      looks_ += b.to - b.from;
      for (std::size_t j = b.from; j < b.to; ++j) count(edges_[i], edges_[j]);
    }
    return cost_ <= touches_max && looks_ <= looks_max;
  }
  void count(const Edge& e, const Edge& f) {
    constexpr std::size_t crossing = touches_max / crossings_max, looks_a_pair = 16;
    if (disjoint(e.x, f.x) || disjoint(e.y, f.y)) return;
    looks_ += looks_a_pair;
    if (share_an_end(e, f)) {
      ++cost_;  // they meet there, or lie on one another
    } else if (const auto at = edges_.meeting(e, f)) {
      cost_ += is_end(*at, e) || is_end(*at, f) ? 1 : crossing;
    }
  }

  Edges edges_;
  std::vector<Box> boxes_;
  bool turned_ = false;
  std::size_t cost_ = 0, looks_ = 0;
};

std::vector<Rings> different(const std::vector<Region>& regions) {
  std::vector<Rings> all;
  for (const Region& region : regions) all.push_back(region.rings());
  std::sort(all.begin(), all.end(), before);
  const auto equal = [](const Rings& a, const Rings& b) { return !before(a, b) && !before(b, a); };
  all.erase(std::unique(all.begin(), all.end(), equal), all.end());
  return all;
}

std::size_t meeting_cost(const std::vector<Rings>& regions) {
  return regions.size() > 1 ? Boundaries(regions).cost() : 0;
}

}  // namespace

std::size_t meeting_cost(const std::vector<Region>& regions) {
  return meeting_cost(different(regions));
}
bool cross_too_often(const std::vector<Region>& regions) {
  return meeting_cost(regions) > touches_max;
}

std::optional<Region> united(std::vector<Region> regions) {
  if (regions.size() == 1) return std::move(regions[0]);
  std::vector<Rings> parts = different(regions);
  if (meeting_cost(parts) > touches_max) return std::nullopt;
  Rings all;
  for (Rings& rings : parts) std::move(rings.begin(), rings.end(), std::back_inserter(all));
  return Region::of_rings(all);
}

}  // namespace rtac::geometry
