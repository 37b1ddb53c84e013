#include "compiler/recheck/entering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"
#include "compiler/recheck/starts.h"

namespace rtac::recheck {
namespace {

// Where a way may end, and the share of it after which it has been found to be farthest off.
struct End {
  Place place;
  double clearance;
  int ring;            // of cells, around the one that the search begins at
  bool stays = false;  // a way there does, or is none
  double farthest = 0.5;
};
double turn(Place a, Place b, Place c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Entries {
 public:
  Entries(const std::vector<Segment>& zone, const Grid& grid, const std::vector<Segment>& fence,
          const EnteringLimits& limits)
      : zone_(zone),
        grid_(grid),
        fence_(fence),
        limits_(limits),
        square_(std::max(least_square_m, grid.cell)),
        quarters_max_(quarters_of_least +
                      static_cast<int>(std::ceil(std::log2(square_ / least_square_m)))),
        starts_(limits.starts, limits.starts_off),
        near_(zone) {
    if (limits.straight_most > 0) corners_ = corners_inwards();
    if (limits.depth) {
      depth_ = *limits.depth;
      return;
    }
    for (const Segment& s : zone_) depth_ = std::min(depth_, between(s, fence_));
    for (const Segment& s : fence_) depth_ = std::min(depth_, between(s, zone_));
  }

  std::variant<std::optional<geometry::Point>, BadCells> run() {
    double left = 1e300, low = 1e300, right = -1e300, top = -1e300;
    const double more = starts_.off();
    const auto widen = [&](const std::vector<Segment>& edges) {
      for (const Segment& s : edges) {
        left = std::min({left, s.ax, s.bx}), right = std::max({right, s.ax, s.bx});
        low = std::min({low, s.ay, s.by}), top = std::max({top, s.ay, s.by});
      }
    };
    if (starts_.empty()) widen(fence_);
    std::ranges::for_each(starts_.outlines(), widen);
    for (double y = low - more; y < top + more; y += square_) {
      for (double x = left - more; x < right + more; x += square_) {
        const Box square{x, y, x + square_, y + square_};
        const double off = to_zone(middle(square));
        if (starts_.empty()
                ? off > limits_.least + radius(square) + snap_m && contains(middle(square))
                : !starts_.may_be_in(square)) {
          continue;
        }
        const std::vector<End> ends = ends_near(middle(square));
        double reach = off + limits_.straight_most;
        for (const End& e : ends) reach = std::max(reach, apart(e.place, middle(square)));
        const Boundary boundary(
            fence_, middle(square),
            reach + 2 * square_ + std::max(limits_.clearance, limits_.body) + snap_m);
        if (limits_.alone) sight_.emplace(zone_, middle(square), reach + 1 + 2 * square_);
        const bool stays = stays_within(boundary, square, ends, quarters_max_);
        if (steps_ > steps_max) return BadCells{true};
        if (!stays) return std::optional(geometry::Point{Rational(x), Rational(y)});
      }
    }
    return std::optional<geometry::Point>();
  }

 private:
  static constexpr double least_square_m = 0.1, over_cells_loss_m = 0.008;
  // The first goal is told in millimetres, rounded up twice.
  static constexpr double rounded_m = 0.002;
  static constexpr int quarters_of_least = 9, ways_followed_after = 3, parts = 16;
  static constexpr std::int64_t steps_max = 6'000'000'000;
  // The search tries so many cells, ring by ring; with two rings more for the place that it begins
  // at and for cells that are none in its table.
  static constexpr int tests_max = 2000, more_rings = 3, rings_surely = 18;
  // Of the clearance in the fence so much is forgiven, in all: less than the 10 mm that a hold has
  // room for, and more than a way may lose, for the grids.
  [[nodiscard]] double forgiven() const { return std::max(0.0097, limits_.loss + 0.0018); }

  static double apart(Place a, Place b) { return length(a.x - b.x, a.y - b.y); }
  [[nodiscard]] bool contains(Place p) const { return holds(zone_, p); }
  double to_zone(Place p) {
    steps_ += static_cast<std::int64_t>(near_.size());
    double least = 1e300;
    for (const Segment& s : near_) least = std::min(least, square_to(s, p.x, p.y));
    return std::sqrt(least);
  }
  // No way from the square, or from a part of it, is longer than `farthest`: nothing but this is
  // the nearest of the zone's boundary on any of them.
  void look_near(const Box& from, double off, double farthest) {
    const Place m = middle(from);
    const double way =
        std::max(farthest, std::abs(off) + limits_.straight_most) + 2 * radius(from) + snap_m;
    near_.clear();
    for (const Segment& s : zone_) {
      if (std::sqrt(square_to(s, m.x, m.y)) <= std::abs(off) + 2 * way) near_.push_back(s);
    }
  }
  // From the ends of one segment.
  static double between(const Segment& s, const std::vector<Segment>& others) {
    double square = 1e300;
    for (const Segment& o : others) {
      square = std::min({square, square_to(o, s.ax, s.ay), square_to(o, s.bx, s.by)});
    }
    return std::sqrt(square);
  }
  // A way in the zone, from so far inside, loses little of the clearance there, and of that in the
  // fence no more: all of the zone is `depth_` from its boundary. With room for the body that is
  // enough for a fence with an end: what it asks for beyond that is another claim. One from so far
  // outside, less than 0, leads no farther off than that and as little.
  bool keeps_what_it_has(const Boundary& boundary, const Box& from, double inside) const {
    if (starts_.empty() && inside >= limits_.least) return true;
    double kept = std::min(inside, limits_.kept) - limits_.loss;
    // where a body fits it may go over cells
    const bool fits = inside + 2 * radius(from) >= limits_.least;
    if (fits) {
      const double has = std::max(inside, limits_.least);
      kept = std::min(kept, std::min(has, limits_.kept) - over_cells_loss_m);
    }
    return depth_ + kept >= boundary.asked_from(from, limits_.clearance, forgiven());
  }

  // Where the zone is not on the side of the smaller angle, or lines meet that are not two.
  std::vector<Place> corners_inwards() const {
    std::vector<Place> found;
    for (const Segment& s : zone_) {
      const Place v{s.bx, s.by};
      Place beside = v;
      int met = 0;
      for (const Segment& o : zone_) {
        if ((o.ax != v.x || o.ay != v.y) && (o.bx != v.x || o.by != v.y)) continue;
        const bool starts = o.ax == v.x && o.ay == v.y;
        const Place d = starts ? Place{o.bx - v.x, o.by - v.y} : Place{o.ax - v.x, o.ay - v.y};
        const double step = 1e-5 / length(d.x, d.y);
        beside = {beside.x + step * d.x, beside.y + step * d.y};
        ++met;
      }
      if (met != 2 || !contains(beside)) found.push_back(v);
    }
    return found;
  }

  std::vector<End> ends_near(Place p) const {
    const auto cell = [](double at, std::size_t count) {
      return static_cast<int>(std::clamp(std::floor(at), 0.0, double(count) - 1));
    };
    const int columns = static_cast<int>(grid_.columns), rows = static_cast<int>(grid_.rows);
    const int column = cell((p.x - grid_.x) / grid_.cell, grid_.columns);
    const int row = cell((p.y - grid_.y) / grid_.cell, grid_.rows);
    std::vector<End> found;
    int last = std::max(columns, rows), tested = 0;
    for (int off = 0; off <= last; ++off) {
      for (int r = std::max(0, row - off); r <= std::min(rows - 1, row + off); ++r) {
        const int step = std::abs(r - row) == off || off == 0 ? 1 : 2 * off;
        for (int c = column - off; c <= column + off; c += step) {
          if (c < 0 || c >= columns) continue;
          const double clearance = grid_.clearance[static_cast<std::size_t>(r * columns + c)];
          if (clearance >= limits_.tested + table_m) ++tested;  // surely one of the tables, too
          if (clearance < limits_.least) continue;
          found.push_back(
              {middle(grid_.box(static_cast<std::size_t>(c), static_cast<std::size_t>(r), 1)),
               clearance, off});
        }
      }
      if (tested >= tests_max) last = std::min(last, off + more_rings);
    }
    return found;
  }

  bool stays_within(const Boundary& boundary, const Box& from, const std::vector<End>& ends,
                    int times) {
    if (boundary.holds_nobody(from, limits_.body)) return true;
    if (!starts_.empty() && !starts_.may_be_in(from)) return true;
    const double nearest = to_zone(middle(from));
    const double off = contains(middle(from)) ? -nearest : nearest;
    const double inside = -off - radius(from) - snap_m;
    if (keeps_what_it_has(boundary, from, inside)) return true;
    if (steps_ > steps_max) return false;
    // with room beside its middle that may be so of its parts alone
    const bool alike = -off > radius(from) || limits_.loss < forgiven() / 4;
    if (alike && radius(from) > forgiven() / 4 && times > 0 &&
        depth_ + std::min(-off, limits_.least) - limits_.loss >=
            boundary.asked_from(from, limits_.clearance, forgiven()) - radius(from)) {
      return in_quarters(boundary, from, ends, times);
    }
    const double asked = boundary.asked_from(from, limits_.clearance, forgiven());
    // what begins outside goes on in the zone, wherever that is
    if (!starts_.empty() && depth_ < asked) return in_quarters(boundary, from, ends, times);
    if (leads_across(from, off)) {
      return to_the_nearest(boundary, from, off, asked) || in_quarters(boundary, from, ends, times);
    }
    const double farthest = limits_.alone ? farthest_taken(from, ends, off) : 1e300;
    const bool whole = near_.size() == zone_.size() && farthest < 1e300;
    if (whole) look_near(from, off, farthest);
    const bool stays = ways_stay_within(boundary, from, ends, times, off, asked, farthest);
    if (whole) near_ = zone_;
    return stays;
  }
  bool ways_stay_within(const Boundary& boundary, const Box& from, const std::vector<End>& ends,
                        int times, double off, double asked, double farthest) {
    // it takes the first goal that it sees; who fits may take a way over cells there
    const bool fits = !starts_.empty() && radius(from) - off >= limits_.least;
    const bool first = !fits && looks_straight() && farthest < 1e300;
    const double least = first ? limits_.alone->aim - rounded_m - table_m : limits_.least;
    std::vector<End> taken;
    bool all = true;
    for (End e : ends) {
      if (apart(e.place, middle(from)) - radius(from) > farthest || e.clearance < least) continue;
      if (!e.stays) {
        steps_ += 30;
        e.stays = boundary.keeps(from, e.place, asked) ||
                  leads_off(from, e, off, times <= quarters_max_ - ways_followed_after);
      }
      all = all && e.stays;
      if (limits_.alone || !e.stays) taken.push_back(e);
    }
    if (all && to_the_nearest(boundary, from, off, asked)) return true;
    return in_quarters(boundary, from, taken, times);
  }
  // A retreat alone tries the leg across the boundary first, then a cell in sight, and only then
  // for a goal that is less deep.
  [[nodiscard]] bool looks_straight() const {
    return limits_.alone && limits_.alone->reach == 0 && limits_.straight_most > 0;
  }
  // The leg at a right angle to the nearest segment, whichever that is, ends as far from all others
  // as it is long: from all of the square, which the boundary does not cross, none else is taken.
  bool leads_across(const Box& from, double off) {
    const double round = radius(from) + snap_m, far = limits_.straight_most;
    if (!looks_straight() || std::abs(off) <= round) return false;
    const Place m = middle(from);
    for (const Segment& s : zone_) {
      if (std::sqrt(square_to(s, m.x, m.y)) > std::abs(off) + 2 * round) continue;
      const Place a{s.ax, s.ay}, d{s.bx - s.ax, s.by - s.ay};
      const double wide = length(d.x, d.y), along = inner(m - a, d) / wide;
      if (along <= round || along >= wide - round) return false;
      const Place foot{s.ax + along / wide * d.x, s.ay + along / wide * d.y};
      Place on{-d.y / wide, d.x / wide};
      if (!contains({foot.x + 1e-5 * on.x, foot.y + 1e-5 * on.y})) on = {-on.x, -on.y};
      const Place end{foot.x + far * on.x, foot.y + far * on.y};
      steps_ += static_cast<std::int64_t>(zone_.size());
      const bool alone = std::ranges::all_of(zone_, [&](const Segment& o) {
        return &o == &s || std::sqrt(square_to(o, end.x, end.y)) > far + round;
      });
      if (!alone || !contains(end)) return false;
    }
    return true;
  }
  bool in_quarters(const Boundary& boundary, const Box& from, const std::vector<End>& ends,
                   int times) {
    return times > 0 && std::ranges::all_of(quarters(from), [&](const Box& quarter) {
             return stays_within(boundary, quarter, ends, times - 1);
           });
  }
  // Somewhere on the way it is farther from the zone than it may be, from wherever it begins; less
  // than 0 in the zone.
  bool leads_off(const Box& from, End& end, double off, bool closely) {
    const Place m = middle(from);
    const double most = off + 2 * radius(from) + limits_.loss + 0.0001;
    double farthest = -1e300;
    const auto look = [&](double t) {
      const Place at{m.x + t * (end.place.x - m.x), m.y + t * (end.place.y - m.y)};
      const double nearest = to_zone(at);
      if (nearest <= farthest) return;
      const double way = contains(at) ? -nearest : nearest;
      if (way > farthest) end.farthest = t, farthest = way;
    };
    look(end.farthest);
    double low = 0, high = 1;
    for (int round = 0; round < (closely ? 3 : 1) && farthest <= most; ++round) {
      const int count = closely ? parts : parts / 4;
      for (int i = 0; i <= count && farthest <= most; ++i) look(low + (high - low) * i / count);
      const double step = (high - low) / count;
      low = std::max(0.0, end.farthest - step), high = std::min(1.0, end.farthest + step);
    }
    return farthest > most;
  }
  // It takes no cell that is farther off than one to which straight ways in the zone lead from all
  // places of it that may be the nearest one: along its own way there it comes nearer to those. Who
  // begins in the zone keeps what it has on the way there, or has next to nothing.
  double farthest_taken(const Box& from, const std::vector<End>& ends, double off) {
    double nearest = 1e300;
    for (const End& e : ends) {
      const double way = apart(e.place, middle(from)) + radius(from);
      if (e.ring <= rings_surely && e.clearance >= limits_.alone->aim + table_m && way < nearest &&
          in_sight(from, off, e.place)) {
        nearest = way;
      }
    }
    return std::max(nearest, limits_.alone->reach);
  }
  bool in_sight(const Box& from, double off, Place end) {
    const double round = radius(from), few = limits_.loss - 0.0001;
    if (-off > round) {
      return sight_->keeps(from, end, std::min(-off + round, limits_.least) - few);
    }
    if (off < round && 2 * (round - off) > few) return false;
    off = std::max(off, 0.0);
    steps_ += static_cast<std::int64_t>(zone_.size());
    return std::ranges::all_of(zone_, [&](const Segment& s) {
      const Place m = middle(from);
      if (std::sqrt(square_to(s, m.x, m.y)) > off + 2 * radius(from) + snap_m) return true;
      const auto [a, b] = nearest_of(s, from);
      return is_free(a, b, end);
    });
  }
  // No line of the zone meets the triangle, but for what is near its two first corners.
  bool is_free(Place a, Place b, Place end) {
    constexpr double first = 0.001;
    for (Place* p : {&a, &b}) {
      const double way = apart(*p, end);
      if (way <= first) return false;
      *p = {p->x + first / way * (end.x - p->x), p->y + first / way * (end.y - p->y)};
      if (!contains(*p)) return false;
    }
    steps_ += 2 * static_cast<std::int64_t>(zone_.size());
    const auto meets = [](Place p, Place q, const Segment& s) {
      const Place c{s.ax, s.ay}, d{s.bx, s.by};
      return turn(p, q, c) * turn(p, q, d) <= 0 && turn(c, d, p) * turn(c, d, q) <= 0;
    };
    return std::ranges::none_of(zone_, [&](const Segment& s) {
      const Place c{s.ax, s.ay};
      const double ab = turn(a, b, c), be = turn(b, end, c), ea = turn(end, a, c);
      const bool within = (ab > 0 && be > 0 && ea > 0) || (ab < 0 && be < 0 && ea < 0);
      return within || meets(a, end, s) || meets(b, end, s);
    });
  }
  // The places of a line that are nearest to places of the square lie between these.
  static std::pair<Place, Place> nearest_of(const Segment& s, const Box& from) {
    const Place d{s.bx - s.ax, s.by - s.ay};
    double first = 1, last = 0;
    for (const Place p : corners(from)) {
      const double t = std::clamp(inner({p.x - s.ax, p.y - s.ay}, d) / inner(d, d), 0.0, 1.0);
      first = std::min(first, t), last = std::max(last, t);
    }
    return {{s.ax + first * d.x, s.ay + first * d.y}, {s.ax + last * d.x, s.ay + last * d.y}};
  }
  // Through the nearest place of each line that may be nearest, or away from it, at a right angle,
  // up to any distance that may be wanted; from inside, away from corners that point there.
  bool to_the_nearest(const Boundary& boundary, const Box& from, double off, double asked) {
    const double round = radius(from) + snap_m, near = std::abs(off) + 2 * round;
    const bool little = off < round && falls_little(std::max(-off - round, 0.0), round, asked);
    if (little && -off > round) return true;
    const Place m = middle(from);
    const bool all = std::ranges::all_of(zone_, [&](const Segment& s) {
      if (std::sqrt(square_to(s, m.x, m.y)) > near) return true;
      const auto [a, b] = nearest_of(s, from);
      if (limits_.straight_most <= 0) return boundary.keeps(from, a, b, asked);
      return goes_across(boundary, from, asked, s, a, b);
    });
    if (!all || off >= round || little || limits_.straight_most <= 0) return all;
    return std::ranges::all_of(corners_, [&](Place v) {
      return apart(v, m) > near || leads_from(boundary, from, asked, v);
    });
  }
  // At a right angle, to either side. What is as far from both sides of a corner up to a micrometre
  // is askew by so much.
  bool goes_across(const Boundary& boundary, const Box& from, double asked, const Segment& s,
                   Place a, Place b) {
    const double wide = length(s.bx - s.ax, s.by - s.ay);
    const Place along{(s.bx - s.ax) / wide, (s.by - s.ay) / wide};
    const double askew = std::sqrt(2e-6 * limits_.straight_most) + 0.0005;
    return std::ranges::all_of(std::array<double, 2>{1, -1}, [&](double side) {
      const Place on{-side * along.y, side * along.x};
      return goes_straight(boundary, from, asked, [&](double far) {
        return std::vector<Place>{
            {a.x + far * on.x - askew * along.x, a.y + far * on.y - askew * along.y},
            {b.x + far * on.x + askew * along.x, b.y + far * on.y + askew * along.y}};
      });
    });
  }
  // Straight away from one place, of which all of the square is on one side.
  bool leads_from(const Boundary& boundary, const Box& from, double asked, Place v) {
    const Place m = middle(from);
    const double way = apart(v, m);
    if (way <= 2 * radius(from)) {  // anywhere
      const double far = limits_.straight_most + 0.001;
      return boundary.keeps_to(from,
                               {{v.x - far, v.y - far},
                                {v.x + far, v.y - far},
                                {v.x + far, v.y + far},
                                {v.x - far, v.y + far}},
                               asked);
    }
    const Place on{(m.x - v.x) / way, (m.y - v.y) / way};
    const double wide = radius(from) / std::sqrt(way * way - radius(from) * radius(from));
    // the arc lies between its ends and where its tangent in the middle meets the sides
    return goes_straight(boundary, from, asked, [&](double far) {
      std::vector<Place> ends;
      for (const double ahead : {far, far / std::hypot(1, wide)}) {
        for (const double beside : {ahead * wide, -ahead * wide}) {
          ends.push_back({v.x + ahead * on.x + beside * on.y, v.y + ahead * on.y - beside * on.x});
        }
      }
      return ends;
    });
  }
  // To between those ends, as far off as all of the zone's boundary is from there. Where no place
  // is so far from it, none is farther.
  template <class Ends>
  bool goes_straight(const Boundary& boundary, const Box& from, double asked, const Ends& ends) {
    for (double far = limits_.straight_most; far >= limits_.least; far *= 0.9) {
      const std::vector<Place> here = ends(far);
      if (boundary.keeps_to(from, here, asked)) return true;
      const std::vector<Place> next = ends(0.9 * far);
      const Place p = next.front();
      double spread = 0.0005;
      for (const Place q : next) spread = std::max(spread, apart(p, q) + 0.0005);
      const double gap = to_zone(p);
      const bool none = gap + spread < 0.9 * far || (gap > spread && !contains(p));
      if (!none) return false;
    }
    return true;
  }
  // Straight from c off one place of the boundary of the zone to w off all of it: of what is y
  // ahead and x beside, at least A off at first and w + depth at last, x is least where neither
  // says more. Less than is forgiven is lost for no greater y than the root of A^2 - (A -
  // forgiven)^2, from all c between `least` and so much more; with less to keep that holds as well.
  [[nodiscard]] bool falls_little(double least, double more, double asked) const {
    const double w = limits_.straight_least, most = least + 2 * more;
    if (w <= most + 0.02 || limits_.straight_most <= 0) return false;
    const double has = asked + forgiven(), last = w + depth_;
    const double y = (has * has + (w - least) * (w - least) - last * last) / (2 * (w - most));
    return last >= asked && (y <= 0 || y * y <= has * has - asked * asked);
  }

  const std::vector<Segment>& zone_;
  const Grid& grid_;
  const std::vector<Segment>& fence_;
  const EnteringLimits limits_;
  // in m: no wider than a cell, so that the search begins in the same one, or one beside it
  const double square_;
  const int quarters_max_;
  const Starts starts_;            // which may overlap
  std::vector<Place> corners_;     // of the zone, that point into it
  double depth_ = 1e300;           // of the zone in the fence
  std::optional<Boundary> sight_;  // of the zone
  std::vector<Segment> near_;      // of the zone, what matters to a square
  std::int64_t steps_ = 0;
};

}  // namespace

std::variant<std::optional<geometry::Point>, BadCells> enters_beyond(const geometry::Region& zone,
                                                                     const Cells& cells,
                                                                     const geometry::Region& fence,
                                                                     const EnteringLimits& limits) {
  const std::vector<Segment> inner_edges = segments_of(zone), outer_edges = segments_of(fence);
  const std::optional<Grid> grid = grid_of(inner_edges, cells);
  if (!grid) return BadCells{};
  return Entries(inner_edges, *grid, outer_edges, limits).run();
}

}  // namespace rtac::recheck
