#include "compiler/geometry/spread.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "compiler/geometry/nearby.h"

namespace rtac::geometry {
namespace {

using Line = std::vector<Vector>;  // of a ring: the first vertex is the last one, too

// Rings times edges, and steps of the walks: some tenths of a second.
constexpr double comparisons_max = 2e7;
constexpr std::size_t steps_max = 20'000'000;

Vector vector_of(const GridPoint& p) {
  return {static_cast<double>(p.x_mm), static_cast<double>(p.y_mm)};
}
double length(const Vector& v) {
  return std::hypot(v.x, v.y);
}

std::vector<Line> rings_of(const std::vector<EdgeRow>& edges) {
  std::vector<Line> rings;
  bool is_closed = true;
  GridPoint first{};
  for (const EdgeRow& e : edges) {
    if (is_closed) {
      rings.push_back({vector_of(e.a)});
      first = e.a;
    }
    rings.back().push_back(vector_of(e.b));
    is_closed = e.b == first;
  }
  return rings;
}

// A place on a line: that share of the way from one vertex to the next.
struct At {
  std::size_t edge = 0;
  double share = 0;
};
Vector place(const Line& line, const At& at) {
  return line[at.edge] + at.share * (line[at.edge + 1] - line[at.edge]);
}
// The share of the edge from a to b that is nearest to p, not before `least`.
double nearest_share(const Vector& p, const Vector& a, const Vector& b, double least) {
  const Vector d = b - a;
  const double square = dot(d, d);
  return square > 0 ? std::clamp(dot(p - a, d) / square, least, 1.0) : least;
}

std::pair<At, double> nearest(const Vector& p, const Line& line) {
  std::pair<At, double> best{{}, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const At at{k, nearest_share(p, line[k], line[k + 1], 0)};
    const double gap = length(p - place(line, at));
    if (gap < best.second) best = {at, gap};
  }
  return best;
}

// The ring from that place of it, once round.
Line opened(const Line& ring, const At& at) {
  Line line{place(ring, at)};
  line.insert(line.end(), ring.begin() + static_cast<std::ptrdiff_t>(at.edge) + 1, ring.end());
  line.insert(line.end(), ring.begin() + 1,
              ring.begin() + static_cast<std::ptrdiff_t>(at.edge) + 1);
  line.push_back(line.front());
  return line;
}

// Two walkers, one on each line, who never go back: the least leash that these steps need is no
// shorter than the Frechet distance. Each vertex of the first line is met at the nearest place of
// the second one that is not far ahead.
class Walk {
 public:
  Walk(const Line& one, const Line& other, std::size_t& steps)
      : one_(one), other_(other), steps_(steps) {}

  double leash() {
    for (std::size_t i = 0; i + 1 < one_.size(); ++i) {
      const bool is_last = i + 2 == one_.size();
      go(one_[i], one_[i + 1], is_last ? At{other_.size() - 2, 1} : ahead(one_[i], one_[i + 1]));
    }
    return leash_;
  }

 private:
  At ahead(const Vector& from, const Vector& to) {
    At best = at_;
    double gap = length(to - place(other_, at_));
    const double way_max = 2 * length(to - from) + 2 * gap + 100;
    double way = 0;
    for (At at = at_; at.edge + 1 < other_.size() && way <= way_max; at = {at.edge + 1, 0}) {
      if (++steps_ > steps_max) break;
      const At here{at.edge, nearest_share(to, other_[at.edge], other_[at.edge + 1], at.share)};
      const double found = length(to - place(other_, here));
      if (found < gap) {
        best = here;
        gap = found;
      }
      way += length(other_[at.edge + 1] - place(other_, at));
    }
    return best;
  }
  // The vertices that the other walker passes are met along the way.
  void go(const Vector& from, const Vector& to, const At& next) {
    double share = 0;
    for (std::size_t k = at_.edge + 1; k <= next.edge; ++k) {
      share = nearest_share(other_[k], from, to, share);
      meet(from + share * (to - from), other_[k]);
    }
    meet(to, place(other_, next));
    at_ = next;
  }
  void meet(const Vector& a, const Vector& b) { leash_ = std::max(leash_, length(a - b)); }

  const Line &one_, &other_;
  std::size_t& steps_;
  At at_;
  double leash_ = 0;
};

}  // namespace

// Each ring of one is drawn into one of the other, no place of it over more than F. A place that is
// farther than F from the boundary of either is then enclosed as often by the other one, so that it
// lies in both or in neither, and each boundary is within F of the other one: of such a place
// distances differ by F at most. A place that lies in one alone is within F of both boundaries,
// and on different sides of them: these differ by 2 F. Doubles are off by much less than the last
// millimetre.
std::optional<std::int64_t> spread_mm(const std::vector<EdgeRow>& within,
                                      const std::vector<EdgeRow>& around) {
  const std::vector<Line> inner = rings_of(within);
  std::vector<Line> outer = rings_of(around);
  const double comparisons = static_cast<double>(inner.size()) * static_cast<double>(around.size());
  if (inner.size() != outer.size() || comparisons > comparisons_max) return std::nullopt;
  double most = 0;
  std::size_t steps = 0;
  for (const Line& ring : inner) {
    std::size_t pair = 0;
    std::pair<At, double> start{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const auto found = nearest(ring.front(), outer[k]);
      if (found.second < start.second) start = found, pair = k;
    }
    const Line other = opened(outer[pair], start.first);
    most = std::max({most, start.second, Walk(ring, other, steps).leash()});
    if (steps > steps_max) return std::nullopt;
    std::swap(outer[pair], outer.back());
    outer.pop_back();
  }
  return static_cast<std::int64_t>(std::ceil(2 * most)) + 1;
}

}  // namespace rtac::geometry
