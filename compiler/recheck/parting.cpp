#include "compiler/recheck/parting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/sums.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {
namespace {

constexpr double slack_square = 1e-6;  // m^2, of the doubles of the runtime

double farthest(const Box& a, const Box& b) {
  double most = 0;
  for (const Place p : corners(a)) {
    for (const Place q : corners(b)) most = std::max(most, length(p.x - q.x, p.y - q.y));
  }
  return most;
}
double nearest(const Box& a, const Box& b) {
  return length(std::max({a.x - b.right, b.x - a.right, 0.0}),
                std::max({a.y - b.top, b.y - a.top, 0.0}));
}
// On the way from p to c the distance from q does not fall, for all p and q: (c - p) (p - q) is
// concave in p and linear in q, so that corners are the worst. Signs are exact in doubles, and so
// is what is negative on neither axis.
bool recedes(Place c, const Box& from, const Box& other) {
  double least = 1e300, on_x = 1e300, on_y = 1e300;
  for (const Place p : corners(from)) {
    for (const Place q : corners(other)) {
      on_x = std::min(on_x, (c.x - p.x) * (p.x - q.x));
      on_y = std::min(on_y, (c.y - p.y) * (p.y - q.y));
      least = std::min(least, inner(c - p, p - q));
    }
  }
  return least >= slack_square || (on_x >= 0 && on_y >= 0);
}
// Which side of the other robot one is on, on either axis: -1 or 1.
struct Side {
  int x, y;
};
struct Off {
  double least, most;  // of the difference of two coordinates
};
std::optional<Off> off_on(int sign, double low, double high, double other_low, double other_high) {
  Off off{low - other_high, high - other_low};
  if (sign > 0) off.least = std::max(off.least, 0.0);
  if (sign < 0) off.most = std::min(off.most, 0.0);
  return off.least <= off.most ? std::optional(off) : std::nullopt;
}
// As above where p is on that side of q, also if it is on none: then it is nowhere there.
bool recedes(Place c, const Box& from, const Box& other, Side side) {
  const auto off_x = off_on(side.x, from.x, from.right, other.x, other.right);
  const auto off_y = off_on(side.y, from.y, from.top, other.y, other.top);
  if (!off_x || !off_y) return true;
  const auto least = [](double to, double low, double high, const Off& off) {
    return std::min({(to - low) * off.least, (to - low) * off.most, (to - high) * off.least,
                     (to - high) * off.most});
  };
  const double on_x = least(c.x, from.x, from.right, *off_x);
  const double on_y = least(c.y, from.y, from.top, *off_y);
  return on_x + on_y >= slack_square || (on_x >= 0 && on_y >= 0);
}
// It falls, for all of them: of one axis the product is the largest halfway between c and q.
bool comes_nearer(Place c, const Box& from, const Box& other) {
  const auto most = [](double to, double low, double high, double q) {
    const double p = std::clamp((to + q) / 2, low, high);
    return (to - p) * (p - q);
  };
  const double on_x =
      std::max(most(c.x, from.x, from.right, other.x), most(c.x, from.x, from.right, other.right));
  const double on_y =
      std::max(most(c.y, from.y, from.top, other.y), most(c.y, from.y, from.top, other.top));
  return on_x + on_y < -slack_square;
}

class Partings {
 public:
  Partings(const std::vector<Segment>& all, const Grid& grid, const PartingLimits& limits)
      : all_(all),
        grid_(grid),
        limits_(limits),
        columns_(static_cast<int>(grid.columns)),
        rows_(static_cast<int>(grid.rows)),
        window_(static_cast<int>(std::ceil(limits.goal / grid.cell)) + 3),
        joins_(std::max(reach_m, 2 * grid.cell)),
        far_(std::min(1.5 * limits.route + 4 * grid.cell + 0.4, rings * grid.cell)),
        sites_(grid.clearance.size()) {}

  std::variant<Meeting, BadCells> run() {
    const int around = static_cast<int>(limits_.apart / grid_.cell) + 2;
    for (int one = 0; one < columns_ * rows_; ++one) {
      if (holds_nobody(site(one), box(one))) continue;
      for (int r = row(one); r <= std::min(rows_ - 1, row(one) + around); ++r) {
        const int first = r == row(one) ? column(one) : std::max(0, column(one) - around);
        for (int c = first; c <= std::min(columns_ - 1, column(one) + around); ++c) {
          const int other = r * columns_ + c;
          if (nearest(box(one), box(other)) >= limits_.apart) continue;
          const bool parts = part(one, other, false) || part(one, other, true);
          if (steps_ > steps_max) return BadCells{};
          if (!parts) return Meeting({exact(one), exact(other)});
        }
      }
    }
    return Meeting();
  }

 private:
  // Of the cells around a place it tries all in so many rings, whatever else it tries.
  static constexpr int rings = 20;
  // A square of robots is quartered so many times at most: of the one that leaves, and of both.
  static constexpr int quarters_max = 5, quarters_of_both_max = 4;
  static constexpr std::int64_t steps_max = 4'000'000'000;
  // The runtime joins to cells within the larger of 0.4 m and two cells, and forgives 8 mm of
  // clearance on the way there; 7 are counted on.
  static constexpr double reach_m = 0.4, forgiven_m = 0.007;

  // Around a cell: the boundary, and the cells that may be joined to.
  struct Site {
    bool known = false;
    std::unique_ptr<Boundary> boundary;
    std::vector<int> joined, far;
  };

  [[nodiscard]] int column(int cell) const { return cell % columns_; }
  [[nodiscard]] int row(int cell) const { return cell / columns_; }
  [[nodiscard]] Box box(int cell) const {
    return grid_.box(static_cast<std::size_t>(column(cell)), static_cast<std::size_t>(row(cell)),
                     1);
  }
  [[nodiscard]] geometry::Point exact(int cell) const {
    const Place m = middle(box(cell));
    return {Rational(m.x), Rational(m.y)};
  }
  [[nodiscard]] bool clear(int c, int r) const {
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ &&
           grid_.clearance[static_cast<std::size_t>(r * columns_ + c)] >= limits_.route;
  }
  [[nodiscard]] bool clear(int cell) const { return clear(column(cell), row(cell)); }

  Site& site(int cell) {
    Site& s = sites_[static_cast<std::size_t>(cell)];
    if (s.known) return s;
    s.known = true;
    const Place m = middle(box(cell));
    const double limit = far_ + grid_.cell + std::max(limits_.route, limits_.body) + snap_m;
    s.boundary = std::make_unique<Boundary>(all_, m, limit);
    const int off = static_cast<int>(far_ / grid_.cell);
    for (int r = row(cell) - off; r <= row(cell) + off; ++r) {
      for (int c = column(cell) - off; c <= column(cell) + off; ++c) {
        if (!clear(c, r)) continue;
        const Place to = middle(box(r * columns_ + c));
        const double way = length(to.x - m.x, to.y - m.y);
        if (way <= joins_ + slack_m) s.joined.push_back(r * columns_ + c);
        if (way > joins_ + slack_m && way <= far_ && !clear(cell))
          s.far.push_back(r * columns_ + c);
      }
    }
    return s;
  }
  [[nodiscard]] bool holds_nobody(const Site& s, const Box& b) const {
    return s.boundary->holds_nobody(b, limits_.body);
  }
  [[nodiscard]] bool keeps(const Site& s, const Box& from, Place c) const {
    return s.boundary->keeps(from, c, s.boundary->asked_from(from, limits_.route, forgiven_m));
  }

  // Of the cells around one, those from whose middles steps lead to a goal, each of them receding
  // from all of the square. Such ways lead away from its middle, too: the cells by how far they are
  // from there, the farthest first.
  const std::vector<bool>& ways(int there, const Box& other) {
    const int width = 2 * window_ + 1, west = column(there) - window_, south = row(there) - window_;
    std::vector<bool>& leads = ways_[{other.x, other.y, other.right}];
    if (!leads.empty()) return leads;
    leads.assign(static_cast<std::size_t>(width * width), false);
    std::vector<std::pair<double, int>> order;
    const Place q = middle(other);
    for (int i = 0; i < width * width; ++i) {
      const int c = west + i % width, r = south + i / width;
      if (!clear(c, r)) continue;
      const Place p = middle(box(r * columns_ + c));
      order.emplace_back(-length(p.x - q.x, p.y - q.y), i);
    }
    std::sort(order.begin(), order.end());
    steps_ += 8 * width * width;
    for (const auto& [minus_distance, i] : order) {
      const int c = west + i % width, r = south + i / width;
      const Place p = middle(box(r * columns_ + c));
      const Box here{p.x, p.y, p.x, p.y};
      bool lead = nearest(here, other) >= limits_.goal;
      for (int dr = -1; dr <= 1 && !lead; ++dr) {
        for (int dc = -1; dc <= 1 && !lead; ++dc) {
          const int x = i % width + dc, y = i / width + dr;
          if (x < 0 || y < 0 || x >= width || y >= width) continue;
          if (!leads[static_cast<std::size_t>(y * width + x)]) continue;
          const bool open = clear(c + dc, r) && clear(c, r + dr);
          lead = open && recedes(middle(box((r + dr) * columns_ + c + dc)), here, other);
        }
      }
      leads[static_cast<std::size_t>(i)] = lead;
    }
    return leads;
  }
  bool leads(int cell, int there, const Box& other) {
    const int c = column(cell) - column(there) + window_, r = row(cell) - row(there) + window_;
    const int width = 2 * window_ + 1;
    if (c < 0 || r < 0 || c >= width || r >= width) return clear(cell);
    return ways(there, other)[static_cast<std::size_t>(r * width + c)];
  }

  bool part(int one, int other, bool by_far_cells) {
    by_far_cells_ = by_far_cells;
    return part(one, box(one), other, box(other), quarters_of_both_max);
  }
  bool part(int one, const Box& here, int other, const Box& there, int times) {
    if (farthest(here, there) < limits_.nearest) return true;
    if (nearest(here, there) >= limits_.apart) return true;
    if (leaves(one, here, other, there, 0) || leaves(other, there, one, here, 0)) return true;
    if (leaves(one, here, other, there, quarters_max)) return true;
    if (leaves(other, there, one, here, quarters_max)) return true;
    // or else the one does where it is on one side, and the other one elsewhere
    constexpr std::array<Side, 4> sides{{{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}};
    const bool either = std::ranges::all_of(sides, [&](Side side) {
      return joins_well(one, here, other, there, side) ||
             joins_well(other, there, one, here, Side{-side.x, -side.y});
    });
    if (either) return true;
    if (times == 0 || steps_ > steps_max) return false;
    for (const Box& a : quarters(here)) {
      if (holds_nobody(site(one), a)) continue;
      for (const Box& b : quarters(there)) {
        if (holds_nobody(site(other), b)) continue;
        if (!part(one, a, other, b, times - 1)) return false;
      }
    }
    return true;
  }
  bool leaves(int one, const Box& here, int other, const Box& there, int times) {
    if (holds_nobody(site(one), here) || farthest(here, there) < limits_.nearest) return true;
    if (joins_well(one, here, other, there)) return true;
    if (times == 0 || steps_ > steps_max) return false;
    return std::ranges::all_of(quarters(here), [&](const Box& quarter) {
      return leaves(one, quarter, other, there, times - 1);
    });
  }
  // The search begins with its own cell alone, where that is clear and the way to its middle
  // recedes; else with all that are near, or else with the nearest one that it can join to.
  bool joins_well(int one, const Box& here, int other, const Box& there,
                  std::optional<Side> side = {}) {
    const Site& s = site(one);
    const auto harmless = [&](int cell) {
      return leads(cell, other, there) || comes_nearer(middle(box(cell)), here, there);
    };
    if (clear(one) && !harmless(one)) return false;
    const auto joins = [&](int cell) {
      ++steps_;
      const Place c = middle(box(cell));
      const bool away = side ? recedes(c, here, there, *side) : recedes(c, here, there);
      return away && leads(cell, other, there) && keeps(s, here, c);
    };
    if (std::ranges::any_of(s.joined, joins)) return true;
    if (!by_far_cells_) return false;
    return std::ranges::any_of(s.far, [&](int cell) {
      if (!joins(cell)) return false;
      const Place c = middle(box(cell));
      const double way = farthest({c.x, c.y, c.x, c.y}, here);
      const auto farther = [&](int to) {
        const Place t = middle(box(to));
        return nearest({t.x, t.y, t.x, t.y}, here) > way || harmless(to);
      };
      return way + grid_.cell <= far_ && std::ranges::all_of(s.joined, farther) &&
             std::ranges::all_of(s.far, farther);
    });
  }

  const std::vector<Segment>& all_;
  const Grid& grid_;
  const PartingLimits limits_;
  const int columns_, rows_, window_;
  const double joins_, far_;
  std::vector<Site> sites_;
  std::map<std::array<double, 3>, std::vector<bool>> ways_;
  bool by_far_cells_ = false;
  std::int64_t steps_ = 0;
};

}  // namespace

std::variant<Meeting, BadCells> without_parting(const geometry::Region& zone, const Cells& cells,
                                                const PartingLimits& limits) {
  const std::vector<Segment> all = segments_of(zone);
  const std::optional<Grid> grid = grid_of(all, cells);
  if (!grid) return BadCells{};
  return Partings(all, *grid, limits).run();
}

namespace {

// The largest distance that the property asks robots to keep; none: it asks for something else.
std::optional<Rational> apart_by(const sema::Spec& spec, const sema::Expr& e) {
  if (const auto* others = std::get_if<sema::ForOthers>(&e.node)) {
    return others->universal ? apart_by(spec, *others->body) : std::nullopt;
  }
  if (const auto* logic = std::get_if<sema::Logic>(&e.node)) {
    if (logic->op != sema::LogicOp::logical_and) return std::nullopt;
    Rational most = 0;
    for (const sema::ExprPtr& operand : logic->operands) {
      const auto asked = apart_by(spec, *operand);
      if (!asked) return std::nullopt;
      most = std::max(most, *asked);
    }
    return most;
  }
  return least_distance(spec, e);
}

// Whether no other recovery than that of `m` may drive where `m` is engaged.
bool drives_alone(const sema::Spec& spec, const sema::Decision& d, const sema::Monitor& m) {
  for (const sema::MonitorId id : d.priority) {
    if (&spec[id] == &m && !d.coordinated) return true;
    if (spec[id].recover != m.recover) return false;
  }
  return true;
}

}  // namespace

std::optional<Doubt> check_parting(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                                   const sema::Monitor& m, const Values& v) {
  const sema::RobotKind& kind = spec[d.kind];
  const auto zone = claims.zones().find(text(v, "zone"));
  const auto cell = number(v, "cell_mm"), x = number(v, "cells_x_mm"), y = number(v, "cells_y_mm");
  const auto route = number(v, "route_mm"), gap = number(v, "gap_mm");
  const auto extra = number(v, "extra_us");
  if (!zone || !cell || !x || !y || !route || !gap || !extra) {
    return wrong("a number is missing");
  }
  const auto steps = sema::templates_of(spec[*m.recover]);
  const auto* yield = steps.empty() ? nullptr : std::get_if<sema::Yield>(&steps.back());
  if (yield == nullptr || yield->zone != *zone) return wrong("its recovery makes no room there");
  const auto robots = std::ranges::count_if(
      spec.robots, [&](const sema::Robot& robot) { return robot.kind == d.kind; });
  if (robots != 2 || kind.open_fleet || kind.in_space) return wrong("they are no two in the plane");
  if (!drives_alone(spec, d, m)) return wrong("another recovery may drive instead");
  const auto asked = apart_by(spec, *m.always);
  if (!asked) return wrong("its property asks for more than a distance from other robots");
  const Numbers n = numbers_of(spec, d, jitter_of(spec, d));
  if (milli(*route) < claims.leg_clearance(d, m, *zone)) return wrong(too_near);
  // at rest, with the other one somewhere around where it was measured and holds
  const Rational held = n.radius + 2 * n.position_error + n.hold + *asked;
  if (milli(*gap) < claims.return_clearance(d, m, micro(*extra)) + held) {
    return wrong("control may not be given back at that distance");
  }
  const geometry::Region* const region = claims.zones().region(*zone);
  if (region == nullptr || region->empty()) return Doubt{false, "the zone is not known"};
  const double error = n.position_error.get_d(), far = milli(*gap).get_d();
  const double body = std::max(0.0, n.radius.get_d() - error);
  const auto found =
      without_parting(*region, {*cell, *x, *y},
                      {milli(*route).get_d(), body, 2 * body, far + error, far + 3 * error});
  const auto* const meeting = std::get_if<Meeting>(&found);
  if (meeting == nullptr) return wrong("the cells are not those of the zone, or too many");
  if (!*meeting) return std::nullopt;
  const auto place = [](const geometry::Point& p) {
    return "(" + to_decimal(p.x) + " m, " + to_decimal(p.y) + " m)";
  };
  return wrong("robots at " + place((*meeting)->first) + " and " + place((*meeting)->second) +
               " may not get out of each other's way");
}

}  // namespace rtac::recheck
