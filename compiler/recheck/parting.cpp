#include "compiler/recheck/parting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <unordered_set>
#include <vector>

#include "compiler/recheck/at_worst.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/open_sides.h"
#include "compiler/recheck/receding.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/squares.h"
#include "compiler/recheck/sums.h"
#include "compiler/recheck/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// Numbers of pairs of numbers, one of each list.
std::vector<int> pairs_of(const std::vector<int>& some, const std::vector<int>& others) {
  std::map<std::pair<int, int>, int> known;
  std::vector<int> all;
  for (std::size_t i = 0; i < some.size(); ++i) {
    const std::pair pair{some[i], others[i]};
    all.push_back(known.try_emplace(pair, static_cast<int>(known.size())).first->second);
  }
  return all;
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
        joins_(std::max(reach_m, 2 * grid.cell) + slack_m),
        far_(std::min(1.5 * limits.route + 4 * grid.cell + 0.4, rings * grid.cell)),
        far_cells_(static_cast<int>(far_ / grid.cell)),
        forgiven_(grid.less > 0 ? forgiven_m - snap_m : forgiven_m - grid_m),
        sites_(grid.clearance.size()) {
    count_blocked();
  }

  std::variant<Meeting, BadCells> run() {
    find_alike();
    const std::vector<Offset> offsets = near_offsets();
    for (int one = 0; one < columns_ * rows_; ++one) {
      if (ways_.size() * ways_bits() > ways_bits_max) ways_.clear();
      if (alike(one) < 0) continue;
      for (std::size_t i = 0; i < offsets.size(); ++i) {
        const auto& [columns, rows, one_leaves, other_leaves] = offsets[i];
        const int c = column(one) + columns, r = row(one) + rows;
        if (c < 0 || c >= columns_ || r >= rows_) continue;
        const int other = r * columns_ + c;
        ++steps_;
        if (alike(other) < 0 || (open(one) & one_leaves).any() ||
            (open(other) & other_leaves).any())
          continue;
        const std::uint64_t looks = look_of(one, other, i);
        if (!limits_.each_alone && parted_.contains(looks)) continue;
        const bool parts = part(one, other);
        if (steps_ > steps_max) return BadCells{};
        if (!parts) return Meeting({exact(one), exact(other)});
        const bool may_come_again = many(one) > 1 && many(other) > 1;
        if (may_come_again && parted_.size() < parted_max) parted_.insert(looks);
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
  // clearance on the way there. As much of it is lost as its zone may be smaller than the outline,
  // or 1 mm where that is on the grid.
  static constexpr double reach_m = 0.4, forgiven_m = 0.008, grid_m = 0.001;

  // So many pairs that part are remembered.
  static constexpr std::size_t parted_max = 2'000'000;
  // Steps of a way; longer ones are not looked for.
  static constexpr int way_max = 4000;
  // Of ways so many bits, 200 MB; then they are found again.
  static constexpr std::size_t ways_bits_max = 1'600'000'000;

  // Around a cell: the boundary, and the cells that may be joined to.
  struct Site {
    bool known = false;
    std::unique_ptr<Boundary> boundary;
    std::vector<int> joined;              // the nearest first, and so
    std::optional<std::vector<int>> far;  // of those farther off, once somebody asks
    int alike = -1;  // those that look alike have the same number; -1: nobody is there
    OpenSides::Set open;
  };
  // Where one cell is off another one, and over which sides one of two robots there leaves.
  struct Offset {
    int columns, rows;
    OpenSides::Set one_leaves, other_leaves;
  };
  // Two bits of each cell around one: whether it has been asked, and leads.
  using Ways = std::vector<bool>;

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
  // Robots know at least so much of it as to count it among those that ways lead over; or else, of
  // one that only may be among them, no way leads over it, but whoever stands there may have to
  // begin with it.
  [[nodiscard]] bool clear(int c, int r) const { return has(c, r, limits_.route + grid_.less); }
  [[nodiscard]] bool may_be_clear(int cell) const {
    return has(column(cell), row(cell), limits_.route - 2 * slack_m);
  }
  [[nodiscard]] bool has(int c, int r, double clearance) const {
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ &&
           grid_.clearance[static_cast<std::size_t>(r * columns_ + c)] >= clearance;
  }
  [[nodiscard]] bool clear(int cell) const { return clear(column(cell), row(cell)); }
  // All of a rectangle, by sums of what is not: those west and south of each corner.
  void count_blocked() {
    blocked_.assign(static_cast<std::size_t>((columns_ + 1) * (rows_ + 1)), 0);
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c) {
        blocked_[corner(c + 1, r + 1)] = blocked_[corner(c + 1, r)] + blocked_[corner(c, r + 1)] -
                                         blocked_[corner(c, r)] + (clear(c, r) ? 0 : 1);
      }
    }
  }
  [[nodiscard]] std::size_t corner(int c, int r) const {
    return static_cast<std::size_t>(r * (columns_ + 1) + c);
  }
  [[nodiscard]] bool all_clear(int cell, const Block& b) const {
    const int west = column(cell) + b.west, east = column(cell) + b.east + 1;
    const int south = row(cell) + b.south, north = row(cell) + b.north + 1;
    if (west < 0 || south < 0 || east > columns_ || north > rows_) return false;
    return blocked_[corner(east, north)] + blocked_[corner(west, south)] ==
           blocked_[corner(west, north)] + blocked_[corner(east, south)];
  }

  Site& site(int cell) {
    Site& s = sites_[static_cast<std::size_t>(cell)];
    if (s.known) return s;
    s.known = true;
    const Place m = middle(box(cell));
    const double limit = far_ + grid_.cell + std::max(limits_.route, limits_.body) + snap_m;
    s.boundary = std::make_unique<Boundary>(all_, m, limit);
    s.joined = cells_within(cell, -1, joins_);
    return s;
  }
  // Of those that may be joined to, by their way.
  [[nodiscard]] std::vector<int> cells_within(int cell, double beyond, double most) const {
    const int far = static_cast<int>(most / grid_.cell);
    const Place m = middle(box(cell));
    std::vector<int> found;
    for (int r = std::max(0, row(cell) - far); r <= std::min(rows_ - 1, row(cell) + far); ++r) {
      for (int c = std::max(0, column(cell) - far); c <= std::min(columns_ - 1, column(cell) + far);
           ++c) {
        const int to = r * columns_ + c;
        const double off = way(m, to);
        if (may_be_clear(to) && off > beyond && off <= most) found.push_back(to);
      }
    }
    std::ranges::sort(found, {}, [&](int to) { return way(m, to); });
    return found;
  }
  [[nodiscard]] double way(Place from, int to) const {
    const Place p = middle(box(to));
    return length(p.x - from.x, p.y - from.y);
  }
  [[nodiscard]] bool holds_nobody(const Site& s, const Box& b) const {
    return s.boundary->holds_nobody(b, limits_.body);
  }
  [[nodiscard]] bool keeps(const Site& s, const Box& from, Place c) const {
    return s.boundary->keeps(from, c, s.boundary->asked_from(from, limits_.route, forgiven_));
  }

  [[nodiscard]] int alike(int cell) const { return sites_[static_cast<std::size_t>(cell)].alike; }
  [[nodiscard]] int many(int cell) const { return many_[static_cast<std::size_t>(alike(cell))]; }
  [[nodiscard]] OpenSides::Set open(int cell) const {
    return sites_[static_cast<std::size_t>(cell)].open;
  }
  // Of at most 2^17 cells and twice as many offsets.
  [[nodiscard]] std::uint64_t look_of(int one, int other, std::size_t offset) const {
    return (static_cast<std::uint64_t>(alike(one)) << 17U | static_cast<unsigned>(alike(other)))
               << 18U |
           offset;
  }
  // Two cells look alike where the same is clear around them, as far as any way is followed or any
  // cell is joined to, and the outline runs alike, as far as it is looked at. Nothing else is asked
  // of a pair of them but how the one lies to the other: what holds of real numbers at the one
  // place holds at the other, too, and slacks are for the doubles of either.
  void find_alike() {
    const OpenSides sides(grid_.cell, limits_.goal, joins_);
    std::vector<bool> clear_ones, others;
    for (int cell = 0; cell < columns_ * rows_; ++cell) {
      clear_ones.push_back(clear(cell));
      others.push_back(may_be_clear(cell));
    }
    const int off = std::max(window_, far_cells_ + 1);
    squares_ = number_squares(clear_ones, columns_, rows_, off);
    if (others != clear_ones)
      squares_ = pairs_of(squares_, number_squares(others, columns_, rows_, off));
    steps_ += 100 * static_cast<std::int64_t>(squares_.size());
    std::map<std::pair<int, std::vector<std::array<std::int64_t, 4>>>, int> known;
    for (int cell = 0; cell < columns_ * rows_; ++cell) {
      Site& s = site(cell);
      steps_ += static_cast<std::int64_t>(all_.size());
      if (holds_nobody(s, box(cell))) continue;
      const int square = squares_[static_cast<std::size_t>(cell)];
      s.alike = known.try_emplace({square, s.boundary->outline()}, static_cast<int>(known.size()))
                    .first->second;
      many_.resize(known.size());
      ++many_[static_cast<std::size_t>(s.alike)];
    }
    open_up(sides);
  }
  void open_up(const OpenSides& sides) {
    for (int cell = 0; cell < columns_ * rows_; ++cell) {
      for (std::size_t i = 0; i < OpenSides::count; ++i) {
        sites_[static_cast<std::size_t>(cell)].open[i] = all_clear(cell, sides.blocks()[i]);
      }
    }
  }
  // To the same cell and the later ones, as far as robots have to part; not where they would touch.
  [[nodiscard]] std::vector<Offset> near_offsets() {
    constexpr std::int64_t steps_of_each = 1000;
    const OpenSides sides(grid_.cell, limits_.goal, joins_);
    const int around = static_cast<int>(limits_.apart / grid_.cell) + 2;
    const auto at = [&](int c, int r) {
      return Box{c * grid_.cell, r * grid_.cell, (c + 1) * grid_.cell, (r + 1) * grid_.cell};
    };
    std::vector<Offset> all;
    for (int r = 0; r <= std::min(around, rows_ - 1); ++r) {
      const int far = std::min(around, columns_ - 1);
      for (int c = r == 0 ? 0 : -far; c <= far; ++c) {
        const Box one = at(0, 0), other = at(c, r);
        if (nearest(one, other) >= limits_.apart + slack_m) continue;
        if (farthest(one, other) < limits_.nearest - slack_m) continue;
        steps_ += steps_of_each;
        all.push_back({c, r, sides.against(c, r), sides.against(-c, -r)});
        if (limits_.each_alone) all.back().one_leaves = all.back().other_leaves = 0;
      }
    }
    return all;
  }

  // From which of the cells around one, if ways lead over it, steps lead to a goal, each of them
  // receding from all of the square: as far as that has been asked, of all cells that look alike.
  [[nodiscard]] std::size_t ways_bits() const {
    const std::size_t width = 2 * static_cast<std::size_t>(window_) + 1;
    return 2 * width * width;
  }
  Ways& ways(int there, const Box& other) {
    constexpr double per_nm = 1e-9;
    const Box cell = box(there);
    const auto nm = [&](double length) { return std::llround(length / per_nm); };
    Ways& known = ways_[{squares_[static_cast<std::size_t>(there)], nm(other.x - cell.x),
                         nm(other.y - cell.y), nm(other.right - other.x)}];
    if (known.empty()) known.assign(ways_bits(), false);
    steps_ += 10;
    return known;
  }
  bool leads(int cell, int there, const Box& other, Ways& ways, int depth = 0) {
    const int c = column(cell) - column(there) + window_, r = row(cell) - row(there) + window_;
    const int width = 2 * window_ + 1;
    if (c < 0 || r < 0 || c >= width || r >= width) return may_be_clear(cell);
    const std::size_t asked = 2 * static_cast<std::size_t>(r * width + c);
    if (ways[asked]) return ways[asked + 1];
    steps_ += 8;
    const Place p = middle(box(cell));
    const Box here{p.x, p.y, p.x, p.y};
    const bool begins = may_be_clear(cell);
    bool lead = begins && nearest(here, other) >= limits_.goal;
    for (int dr = -1; dr <= 1 && !lead && begins && depth < way_max; ++dr) {
      for (int dc = -1; dc <= 1 && !lead; ++dc) {
        const int x = column(cell) + dc, y = row(cell) + dr;
        if ((dc == 0 && dr == 0) || !clear(x, y)) continue;
        if (!clear(x, row(cell)) || !clear(column(cell), y)) continue;
        const int to = y * columns_ + x;
        lead = recedes(middle(box(to)), here, other) && leads(to, there, other, ways, depth + 1);
      }
    }
    ways[asked] = true;
    ways[asked + 1] = lead;
    return lead;
  }

  bool part(int one, int other) {
    by_far_cells_ = false;
    const bool near_may_do = !site(one).joined.empty() || !site(other).joined.empty();
    if (near_may_do && part(one, box(one), other, box(other), quarters_of_both_max)) return true;
    by_far_cells_ = true;
    return part(one, box(one), other, box(other), quarters_of_both_max);
  }
  bool part(int one, const Box& here, int other, const Box& there, int times) {
    if (farthest(here, there) < limits_.nearest) return true;
    if (nearest(here, there) >= limits_.apart) return true;
    if (leaves(one, here, other, there, 0) || leaves(other, there, one, here, 0)) return true;
    if (leaves(one, here, other, there, quarters_max)) return true;
    if (leaves(other, there, one, here, quarters_max)) return true;
    // or else the one does where it is on one side, and the other one elsewhere
    if (either_leaves(one, here, other, there)) return true;
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
  bool either_leaves(int one, const Box& here, int other, const Box& there) {
    constexpr std::array<Side, 4> sides{{{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}};
    constexpr std::array axes{Axis::x, Axis::y};
    return std::ranges::all_of(sides, [&](Side side) {
      const Side back{-side.x, -side.y};
      const auto goes = [&](Place c) { return recedes(c, here, there, side); };
      const auto comes = [&](Place c) { return recedes(c, there, here, back); };
      if (joins_well(one, here, other, there, goes)) return true;
      if (joins_well(other, there, one, here, comes)) return true;
      return std::ranges::all_of(axes, [&](Axis axis) {
        const auto one_goes = [&](Place c) { return recedes(c, here, side, axis); };
        const auto other_goes = [&](Place c) { return recedes(c, there, back, axis); };
        return joins_well(one, here, other, there, one_goes) ||
               joins_well(other, there, one, here, other_goes);
      });
    });
  }
  bool leaves(int one, const Box& here, int other, const Box& there, int times) {
    if (holds_nobody(site(one), here) || farthest(here, there) < limits_.nearest) return true;
    const auto recedes_from_all = [&](Place c) { return recedes(c, here, there); };
    if (joins_well(one, here, other, there, recedes_from_all)) return true;
    if (times == 0 || steps_ > steps_max) return false;
    return std::ranges::all_of(quarters(here), [&](const Box& quarter) {
      return leaves(one, quarter, other, there, times - 1);
    });
  }
  // The search begins with its own cell, with all that are near where that leads to nothing, or
  // else with the nearest one that it can join to.
  template <class Away>
  bool joins_well(int one, const Box& here, int other, const Box& there, const Away& away) {
    const Site& s = site(one);
    Ways& known = ways(other, there);
    const auto harmless = [&](int cell) {
      return leads(cell, other, there, known) || comes_nearer(middle(box(cell)), here, there);
    };
    const auto goes = [&](int cell) {
      ++steps_;
      if (!clear(cell)) return false;
      return away(middle(box(cell))) && leads(cell, other, there, known);
    };
    const auto joins = [&](int cell) { return goes(cell) && keeps(s, here, middle(box(cell))); };
    if (std::ranges::any_of(s.joined, joins)) return true;
    if (!by_far_cells_) return false;
    return joins_far_off(one, here, goes, harmless);
  }
  // Nothing that is nearer than where it goes may lead back. The nearest ones are looked at first,
  // as far as they matter to those that are gone to.
  template <class Goes, class Harmless>
  bool joins_far_off(int one, const Box& here, const Goes& goes, const Harmless& harmless) {
    Site& s = site(one);
    if (!s.far) s.far = cells_within(one, joins_, far_);
    const Place m = middle(box(one));
    double back = far_;  // from there on one may
    const auto look_at = [&](int cell) {
      ++steps_;
      const Place t = middle(box(cell));
      const double off = nearest({t.x, t.y, t.x, t.y}, here);
      if (off <= back && !harmless(cell)) back = off;
    };
    std::size_t seen = 0;
    for (const int cell : *s.far) {
      if (way(m, cell) > back + grid_.cell) return false;
      if (!goes(cell)) continue;
      const Place c = middle(box(cell));
      const double most = farthest({c.x, c.y, c.x, c.y}, here);
      if (most + grid_.cell > far_) continue;
      if (seen == 0) std::ranges::for_each(s.joined, look_at);
      while (seen < s.far->size() && way(m, (*s.far)[seen]) <= most + grid_.cell) {
        look_at((*s.far)[seen++]);
      }
      if (most < back && keeps(s, here, c)) return true;
    }
    return false;
  }

  const std::vector<Segment>& all_;
  const Grid& grid_;
  const PartingLimits limits_;
  const int columns_, rows_, window_;
  const double joins_, far_;
  const int far_cells_;
  const double forgiven_;
  std::vector<int> blocked_;
  std::vector<Site> sites_;
  std::vector<int> squares_, many_;  // by cells, and how many look alike
  std::map<std::array<std::int64_t, 4>, Ways> ways_;
  std::unordered_set<std::uint64_t> parted_;  // pairs, by their looks
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

// The largest distance that robots have to keep for `e` to have that value; none: that asks for
// something else.
std::optional<Rational> apart_by(const sema::Spec& spec, const sema::Expr& e, bool value) {
  if (const auto* others = std::get_if<sema::ForOthers>(&e.node)) {
    return others->universal == value ? apart_by(spec, *others->body, value) : std::nullopt;
  }
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr) return least_distance(spec, e, value);
  if (logic->op == sema::LogicOp::logical_not) {
    return apart_by(spec, *logic->operands.front(), !value);
  }
  const auto each = value ? sema::LogicOp::logical_and : sema::LogicOp::logical_or;
  if (logic->op != each) return std::nullopt;
  Rational most = 0;
  for (const sema::ExprPtr& operand : logic->operands) {
    const auto asked = apart_by(spec, *operand, value);
    if (!asked) return std::nullopt;
    most = std::max(most, *asked);
  }
  return most;
}

// Whether what asks for a recovery that only stands are inputs and agents, wherever the robot is,
// or that it is faster than `recovery`, which drives then, but where inputs say so: they let it go
// on.
bool stands_while_told(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Controller& recovery, const sema::Monitor& m) {
  const auto steps = sema::templates_of(spec[*m.recover]);
  if (steps.size() != 1 || !std::holds_alternative<sema::BrakeAndHold>(steps.front())) return false;
  if (speaks_of_windows(*m.always) || !lets_go(spec, d, claims, m, 0)) return false;
  if (!sema::speaks_of_robot(*m.always) || asks_agents_only(*m.always)) return true;
  const Rational extra = return_extra(spec, d);
  Sides sides(spec, d, claims);
  return sides.gives_back(m, extra) && sides.keeps_while_told(recovery, m, extra);
}
// Whether no other recovery than that of `m` may drive where `m` is engaged, but for what is told
// to stand.
bool drives_alone(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                  const sema::Monitor& m) {
  for (const sema::MonitorId id : d.priority) {
    if (&spec[id] == &m && !d.coordinated) return true;
    if (spec[id].recover == m.recover) continue;
    if (!stands_while_told(spec, d, claims, spec[*m.recover], spec[id])) return false;
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
  const auto apart = number(v, "apart_mm"), extra = number(v, "extra_us");
  if (!zone || !cell || !x || !y || !route || !gap || !apart || !extra) {
    return wrong("a number is missing");
  }
  const auto steps = sema::templates_of(spec[*m.recover]);
  const auto* yield = steps.empty() ? nullptr : std::get_if<sema::Yield>(&steps.back());
  if (yield == nullptr || yield->zone != *zone) return wrong("its recovery makes no room there");
  const auto robots = std::ranges::count_if(
      spec.robots, [&](const sema::Robot& robot) { return robot.kind == d.kind; });
  if (robots != 2 || kind.open_fleet) return wrong("they are no two");
  if (!drives_alone(spec, d, claims, m)) return wrong("another recovery may drive instead");
  const auto asked = apart_by(spec, *m.always, true);
  if (!asked) return wrong("its property asks for more than a distance from other robots");
  const Numbers n = numbers_of(spec, d, jitter_of(spec, d));
  if (milli(*route) < claims.leg_clearance(d, m, *zone)) return wrong(too_near);
  // told of a measurement, or of the period before, and anew a period later
  const Rational told = std::max({n.period, n.position_age, n.velocity_age});
  if (!kind.hears_max_age || kind.hears_max_age->value < told + n.period) {
    return wrong("they may never hear where the other one is in time");
  }
  // at rest, with the other one somewhere around where it was measured and holds
  const Rational held = n.radius + 2 * n.position_error + n.hold + *asked;
  const Rational back = claims.return_clearance(d, m, micro(*extra)) + held;
  const auto* const too_near_to_return = "control may not be given back at that distance";
  if (milli(*gap) < back) return wrong(too_near_to_return);
  // who is as far off as others make way to stays where it is; and who is given back needs no way,
  // wherever both are measured then about the places that they hold: wheels hold where they were
  // measured
  const Rational base_moves(1, 100);
  const bool sways = n.sway > 0;
  const Rational seen_off = sways ? n.sway : Rational(2 * n.position_error + base_moves);
  const Rational need_not = back + 2 * seen_off;
  const Rational stays = milli(*gap) + n.position_error;
  if (stays < need_not) return wrong(too_near_to_return);
  if (milli(*apart) < need_not) {
    return wrong("robots that are nearer to each other may have to part, too");
  }
  const geometry::Region* const region = claims.zones().region(*zone);
  if (region == nullptr || region->empty()) return Doubt{false, "the zone is not known"};
  const double error = n.position_error.get_d(), far = milli(*gap).get_d();
  // a point mass holds where the rest of its speed ends, as it was measured then; and may have
  // moved on when the other one does so, too
  const Rational reacts = n.velocity_age + n.period + n.latency;
  const Rational eta = n.velocity_error + (n.brake + n.disturbance) * reacts;
  const Rational rests = eta * n.brake / (n.brake - n.disturbance);
  const Rational latched = n.position_error + (sways ? Rational(rests * reacts / 2) : base_moves);
  const Rational off = sways ? std::min(n.sway, latched) : latched, moved = sways ? n.sway : off;
  const double body = std::max(0.0, Rational(n.radius - off).get_d());
  // in space one may hold straight over the other one
  const double nearest =
      kind.in_space ? 0 : std::max(0.0, Rational(2 * n.radius - off - moved).get_d());
  // doubles may have it a little less than it is
  const Rational nearer = std::max(need_not, Rational(milli(*apart) - Rational(1, 1'000'000)));
  const auto found = without_parting(*region, {*cell, *x, *y},
                                     {milli(*route).get_d(), body, nearest, nearer.get_d(),
                                      far + 3 * error + ends_within(kind, d)});
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
