#include "compiler/geometry/parting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>

#include "compiler/geometry/alike.h"
#include "compiler/geometry/clear_cells.h"
#include "compiler/geometry/clearings.h"
#include "compiler/geometry/connectors.h"
#include "compiler/geometry/kept.h"
#include "compiler/geometry/receding.h"

namespace rtac::geometry {
namespace {

// The cells that two robots stand in are cut into four, and these again, at most so often: that of
// the one that looks for a way, and then both.
constexpr int halvings_max = 5, halvings_of_both_max = 3;
// The search tries the cells around a place ring by ring, 2,000 at most (max_cell_tests), and so
// all of those in so many rings.
constexpr int far_cells_max = 20;
// Cells and legs that are looked at, over all pairs.
constexpr std::int64_t looks_max = 400'000'000;
// So many pairs that part are remembered, as a power of 2.
constexpr int known_bits = 20;
// Cells that ways are remembered of: of two bits each, 200 MB.
constexpr std::size_t known_ways_max = 800'000'000;

// Where robots are put that find no way: so many places of a cell, each way, of two cells and of
// those up to `aside` beside them. From there the search may look as far as this for a leg.
constexpr int finely = 8, coarsely = 4, roughly = 2, aside = 2, farthest_cells = 45;
// So many pairs of places are looked at: of large zones, seconds.
constexpr int placed_max = 40'000;
// Of places of 1 mm; the search forgives 8 mm.
constexpr double forgiven_most_mm = 10;

// Steps of two robots, the shortest first.
std::vector<std::array<Step, 2>> steps_aside() {
  std::vector<std::array<Step, 2>> all;
  constexpr int wide = 2 * aside + 1;
  for (int i = 0; i < wide * wide * wide * wide; ++i) {
    const auto digit = [&](int unit) { return i / unit % wide - aside; };
    all.push_back(
        {Step{digit(1), digit(wide)}, Step{digit(wide * wide), digit(wide * wide * wide)}});
  }
  std::ranges::stable_sort(all, {}, [](const std::array<Step, 2>& both) {
    int length = 0;
    for (const auto& [columns, rows] : both) length += columns * columns + rows * rows;
    return length;
  });
  return all;
}
// Of pairs of places the one nearest to their mean.
std::array<Vec, 2> midst_of(const std::vector<std::array<Vec, 2>>& all) {
  std::array<Vec, 2> mean{};
  for (const auto& pair : all) {
    for (std::size_t i = 0; i < 2; ++i) {
      mean[i].x += pair[i].x / static_cast<double>(all.size());
      mean[i].y += pair[i].y / static_cast<double>(all.size());
    }
  }
  return *std::ranges::min_element(all, {}, [&](const std::array<Vec, 2>& pair) {
    return squared(pair[0].x - mean[0].x) + squared(pair[0].y - mean[0].y) +
           squared(pair[1].x - mean[1].x) + squared(pair[1].y - mean[1].y);
  });
}

// What is proved has to be found once more from exact outlines, of which cells are not known to the
// millimetre where corners are off the grid (recheck/grid.h): whether ways lead over those that are
// so much clearer or less is left open. And legs lose what outlines differ by of what is forgiven
// them.
struct Unsure {
  std::int32_t clearance_mm = 0;
  double forgiven_mm = 7;
};
constexpr Unsure off_the_grid{5, 2};

class Search {
 public:
  Search(const std::vector<EdgeRow>& edges, const CellGrid& cells, const PartingQuery& query,
         const Unsure& unsure)
      : edges_(edges),
        cells_(cells),
        query_(query),
        size_(cells.cell_mm),
        far_mm_(std::min(1.5 * query.clearance_mm + 4 * size_ + 400, far_cells_max * size_)),
        window_(static_cast<int>(std::ceil(query.goal_mm / size_)) + 3),
        unsure_(unsure),
        clear_(cells, query.clearance_mm + unsure_.clearance_mm),
        may_be_clear_(cells, query.clearance_mm - unsure_.clearance_mm),
        alike_(cells, clear_, may_be_clear_, connectors(), around_cells(), far_mm_),
        stands_(edges, query.clearance_mm, std::max(query.body_mm, query.stands_mm + 1)),
        sights_(edges, query.clearance_mm, query.body_mm, forgiven_most_mm),
        holds_somebody_(alike_.kinds()),
        places_(cells.clearance_mm_lo.size()) {
    looks_ += alike_.looked_at();
    const Clearings clearings = clearings_of();
    for (int cell = 0; index(cell) < places_.size(); ++cell) {
      steps_.push_back(steps_from(cell));
      clearings_.push_back(clearings.clear_from(clear_, column(cell), row(cell)));
    }
  }

  Parting run() {
    const std::vector<Near> near = near_cells();
    if (const auto hopeless = pair_beyond_all_goals(near)) {
      return stuck_in(hopeless->first, hopeless->second);
    }
    for (int one = 0; index(one) < places_.size(); ++one) {
      forget_before(one);
      if (!holds_somebody(one)) continue;
      for (std::size_t i = 0; i < near.size(); ++i) {
        const auto& [step, one_leaves, other_leaves] = near[i];
        const int c = column(one) + step.columns, r = row(one) + step.rows;
        if (c < 0 || c >= cells_.columns || r >= cells_.rows) continue;
        const int other = r * cells_.columns + c;
        ++looks_;
        if ((clearings_[index(one)] & one_leaves) != 0 ||
            (clearings_[index(other)] & other_leaves) != 0 || !holds_somebody(other) ||
            is_known(one, other, i)) {
          continue;
        }
        const bool part = they_part(one, other);
        if (looks_ > looks_max) return {Parting::How::too_large, {}, {}};
        if (!part) return stuck_in(one, other);
        remember(one, other, i);
      }
    }
    return {};
  }

 private:
  // Of the cells around one, those from whose middles ways lead, as far as that has been asked.
  struct Ways {
    std::vector<bool> asked, lead;
  };
  // The step to a cell, and the sets of clearings over which one of the two leaves the other.
  struct Near {
    Step step;
    std::uint8_t one_leaves, other_leaves;
  };
  // A part of a cell, which legs are sound from anywhere in it, and the ways of others when a robot
  // stands there.
  struct Patch {
    Connectors::Spot spot;
    std::vector<int> sound;
    // the same of those that graze what is not clear, and of those farther off, once it is asked
    // for
    std::vector<std::optional<bool>> grazing{}, far{};
    std::vector<std::optional<Patch>> parts{};  // none: no body can be there
    int last = -1;  // the leg that did for one place of the other robot: often for the next, too
    std::shared_ptr<Ways> ways{};
  };
  struct Place {
    bool looked_at = false;
    std::vector<int> landings;  // the search joins to all of them,
    std::vector<int> grazing;   // these among them, from a clear cell, not over clear cells alone,
    std::vector<int> far;       // or else to the nearest one of these: by distance
    std::unique_ptr<Connectors> connectors;  // none: all is clear as far as legs lead
    std::optional<Patch> patch;
  };
  struct Robot {
    int cell;
    Place& place;
    Patch& patch;
  };

  static std::size_t index(int cell) { return static_cast<std::size_t>(cell); }
  [[nodiscard]] int column(int cell) const { return cell % cells_.columns; }
  [[nodiscard]] int row(int cell) const { return cell / cells_.columns; }
  [[nodiscard]] Vec middle(int cell) const {
    return {cells_.origin.x_mm + (column(cell) + 0.5) * size_,
            cells_.origin.y_mm + (row(cell) + 0.5) * size_};
  }
  [[nodiscard]] double squared_off(int cell, Vec p) const {
    return squared(middle(cell).x - p.x) + squared(middle(cell).y - p.y);
  }
  static GridPoint rounded(Vec p) {
    return {static_cast<std::int32_t>(std::lround(p.x)),
            static_cast<std::int32_t>(std::lround(p.y))};
  }
  // Ways lead over it; or else, of one that only may be among those, no way does, but whoever
  // stands there may have to begin with it.
  [[nodiscard]] bool is_clear(int cell) const { return clear_.at(column(cell), row(cell)); }
  [[nodiscard]] bool may_be_clear(int cell) const {
    return may_be_clear_.at(column(cell), row(cell));
  }
  [[nodiscard]] Connectors connectors() const {
    return {edges_, query_.clearance_mm, query_.body_mm, unsure_.forgiven_mm};
  }
  static Box box_of(const Connectors::Spot& spot) {
    return {{spot.x_mm, spot.y_mm}, spot.side_mm / 2};
  }

  // The cells whose middles are within `reach_mm` of one's, on either axis.
  template <class Visit>
  void around(int cell, double reach_mm, const Visit& visit) const {
    const int far = static_cast<int>(reach_mm / size_), x = column(cell), y = row(cell);
    for (int r = std::max(0, y - far); r <= std::min(cells_.rows - 1, y + far); ++r) {
      for (int c = std::max(0, x - far); c <= std::min(cells_.columns - 1, x + far); ++c) {
        visit(r * cells_.columns + c);
      }
    }
  }
  // Which steps lead on between cells that ways lead over, one bit each: a diagonal one touches
  // both cells beside it.
  [[nodiscard]] std::uint8_t steps_from(int cell) const {
    std::uint8_t all = 0;
    for (std::size_t i = 0; i < steps.size() && may_be_clear(cell); ++i) {
      const int c = column(cell) + steps[i].columns, r = row(cell) + steps[i].rows;
      if (c < 0 || r < 0 || c >= cells_.columns || r >= cells_.rows) continue;
      const bool passes = is_clear(r * cells_.columns + c) &&
                          is_clear(row(cell) * cells_.columns + c) &&
                          is_clear(r * cells_.columns + column(cell));
      if (passes) all = static_cast<std::uint8_t>(all | 1U << i);
    }
    return all;
  }
  [[nodiscard]] Clearings clearings_of() const {
    return {size_, static_cast<double>(query_.goal_mm), landing_reach_mm()};
  }
  // Two robots from which no cell that ways lead over is as far off as ways end: whoever stands
  // there need not look for any. Long distances in halls that are hardly longer have many such
  // pairs.
  [[nodiscard]] std::optional<std::pair<int, int>> pair_beyond_all_goals(
      const std::vector<Near>& near) {
    int west = cells_.columns, east = -1, south = cells_.rows, north = -1;
    for (int cell = 0; index(cell) < places_.size(); ++cell) {
      if (!may_be_clear(cell)) continue;
      west = std::min(west, column(cell)), east = std::max(east, column(cell));
      south = std::min(south, row(cell)), north = std::max(north, row(cell));
    }
    const auto has_no_goal = [&](int cell) {
      const int c = std::max(column(cell) - west, east - column(cell)) + 1;
      const int r = std::max(row(cell) - south, north - row(cell)) + 1;
      return size_ * size_ * (squared(c) + squared(r)) < squared(query_.goal_mm);
    };
    for (int one = 0; index(one) < places_.size(); ++one) {
      if (!has_no_goal(one) || !holds_somebody(one)) continue;
      for (const Near& to : near) {
        const int c = column(one) + to.step.columns, r = row(one) + to.step.rows;
        if (c < 0 || c >= cells_.columns || r >= cells_.rows) continue;
        const int other = r * cells_.columns + c;
        // not all that may be near enough have places that are
        if (!has_no_goal(other) || !holds_somebody(other) || they_part(one, other)) continue;
        if (looks_ > looks_max) return std::nullopt;
        return std::pair{one, other};
      }
    }
    return std::nullopt;
  }
  // From a cell to itself and the later ones of which some place is so near to one of its own.
  [[nodiscard]] std::vector<Near> near_cells() {
    constexpr std::int64_t looks_of_each = 1000;
    std::vector<Near> all;
    const Clearings clearings = clearings_of();
    const int far = static_cast<int>((query_.apart_mm + size_) / size_);
    const int columns = std::min(far, cells_.columns - 1), rows = std::min(far, cells_.rows - 1);
    for (int r = 0; r <= rows; ++r) {
      for (int c = r == 0 ? 0 : -columns; c <= columns; ++c) {
        const Vec off{c * size_, r * size_};
        const double half = size_ / 2;
        if (is_beyond(off, {{}, size_}, query_.apart_mm)) continue;
        if (farthest_squared({{}, half}, {off, half}) < squared(query_.nearest_mm)) continue;
        all.push_back({{c, r}, clearings.that_do({c, r}), clearings.that_do({-c, -r})});
        looks_ += looks_of_each;
        if (query_.each_alone) all.back().one_leaves = all.back().other_leaves = 0;
      }
    }
    return all;
  }

  // As far as legs lead from a cell, with the cells between, and ways around it.
  [[nodiscard]] int around_cells() const {
    return std::max(window_, static_cast<int>(std::max(far_mm_, landing_reach_mm()) / size_) + 1);
  }
  bool holds_somebody(int cell) {
    if (alike_.kind(cell) < 0) return false;
    std::optional<bool>& does = holds_somebody_[index(alike_.kind(cell))];
    if (!does) does = place(cell).patch.has_value();
    return *does;
  }
  // Places before this one are not looked at again, and ways are found again where they are.
  void forget_before(int cell) {
    if (cell > 0) places_[index(cell - 1)] = {};
    if (known_ways_.size() * squared_window() > known_ways_max) known_ways_.clear();
  }
  // Whether such a pair has been shown to part. What is forgotten is looked at once more.
  [[nodiscard]] bool is_known(int one, int other, std::size_t offset) {
    return !query_.each_alone && known_[slot(pair(one, other, offset))] == pair(one, other, offset);
  }
  void remember(int one, int other, std::size_t offset) {
    if (alike_.is_single(one) || alike_.is_single(other)) return;  // none like them comes
    known_[slot(pair(one, other, offset))] = pair(one, other, offset);
  }
  // Their kinds and the offset, each of which is less than 2^21, for at most 1,000,000 cells.
  [[nodiscard]] std::uint64_t pair(int one, int other, std::size_t offset) const {
    const auto kind = [&](int cell) { return static_cast<std::uint64_t>(alike_.kind(cell) + 1); };
    return (kind(one) << 21U | kind(other)) << 21U | offset;
  }
  static std::size_t slot(std::uint64_t pair) {
    return static_cast<std::size_t>(pair * 0x9E37'79B9'7F4A'7C15U >> (64 - known_bits));
  }

  // All cells of the rectangle between two are those that ways lead over.
  [[nodiscard]] bool all_clear(int a, int b) const {
    const auto [west, east] = std::minmax({column(a), column(b)});
    const auto [south, north] = std::minmax({row(a), row(b)});
    return clear_.all(west, south, east, north);
  }

  // connector_reach_m of grid_route
  [[nodiscard]] double landing_reach_mm() const { return std::max(400.0, 2 * size_); }
  Place& place(int cell) {
    Place& p = places_[index(cell)];
    if (p.looked_at) return p;
    p.looked_at = true;
    const Vec m = middle(cell);
    // what the search joins to from everywhere in the cell, and what it joins to when there is none
    // of that: in a corner about as far off as ways are clear
    const double reach_mm = landing_reach_mm();
    around(cell, far_mm_, [&](int to) {
      if (!may_be_clear(to)) return;
      const double off_mm = std::hypot(middle(to).x - m.x, middle(to).y - m.y);
      if (off_mm > far_mm_) return;
      (off_mm <= reach_mm ? p.landings : p.far).push_back(to);
    });
    std::ranges::stable_sort(p.far, {}, [&](int to) { return squared_off(to, m); });
    if (!all_clear_around(cell)) {
      p.connectors = std::make_unique<Connectors>(connectors());
    }
    if (!is_clear(cell)) {
      const double half = size_ / 2;
      p.patch = patch_of(p, p.connectors->look_around(m.x - half, m.y - half, size_, far_mm_));
      return p;
    }
    p.patch = Patch{{m.x, m.y, size_, static_cast<double>(query_.clearance_mm)}, {}};
    std::ranges::partition_copy(
        p.landings, std::back_inserter(p.patch->sound), std::back_inserter(p.grazing),
        [&](int to) { return p.connectors == nullptr || all_clear(cell, to); });
    if (p.connectors) {
      (void)p.connectors->look_around(m.x - size_ / 2, m.y - size_ / 2, size_, far_mm_);
    }
    return p;
  }
  // As far as legs lead from there, every place between is as clear as ways are.
  [[nodiscard]] bool all_clear_around(int cell) const {
    const int far = static_cast<int>(far_mm_ / size_) + 1, c = column(cell), r = row(cell);
    return clear_.all(c - far, r - far, c + far, r + far);
  }
  std::optional<Patch> patch_of(const Place& p, const Connectors::Spot& spot) {
    if (p.connectors->holds_nobody(spot)) return std::nullopt;
    Patch patch{spot, {}};
    std::ranges::copy_if(p.landings, std::back_inserter(patch.sound),
                         [&](int to) { return is_clear(to) && is_sound(p, spot, to); });
    return patch;
  }
  bool is_sound(const Place& p, const Connectors::Spot& spot, int to) {
    if (p.connectors == nullptr) return true;
    looks_ += 10;
    return p.connectors->is_sound(spot, {middle(to).x, middle(to).y, 0});
  }
  void cut(Robot one) {
    const auto& [cell, place, patch] = one;
    if (!patch.parts.empty()) return;
    if (!is_clear(cell)) {
      for (const Connectors::Spot& part : place.connectors->quarters(patch.spot)) {
        patch.parts.push_back(patch_of(place, part));
      }
      return;
    }
    const auto& [x_mm, y_mm, side_mm, gap_mm] = patch.spot;
    for (const double y : {y_mm - side_mm / 4, y_mm + side_mm / 4}) {
      for (const double x : {x_mm - side_mm / 4, x_mm + side_mm / 4}) {
        patch.parts.emplace_back(Patch{{x, y, side_mm / 2, gap_mm}, patch.sound});
      }
    }
  }

  bool they_part(int one, int other) {
    if (!place(one).patch || !place(other).patch) return true;  // nobody is there
    const Robot a{one, place(one), *place(one).patch}, b{other, place(other), *place(other).patch};
    by_all_legs_ = false;  // mostly
    const bool near_do = !a.place.landings.empty() || !b.place.landings.empty();
    if (near_do && they_part(a, b, halvings_of_both_max)) return true;
    by_all_legs_ = true;
    return they_part(a, b, halvings_of_both_max);
  }
  // From wherever the two stand in their patches, a way is sure to be found for one of them.
  bool they_part(Robot one, Robot other, int halvings) {
    const Box here = box_of(one.patch.spot), there = box_of(other.patch.spot);
    if (farthest_squared(here, there) < squared(query_.nearest_mm)) return true;
    const Box both{there.middle, here.half + there.half};
    if (is_beyond(here.middle, both, query_.apart_mm)) return true;
    if (leaves(one, other, 0) || leaves(other, one, 0)) return true;  // mostly
    if (leaves(one, other, halvings_max) || leaves(other, one, halvings_max)) return true;
    const Octants off = octants(here, there);
    const bool either = std::all_of(off.begin(), off.end(), [&](const Octant& o) {
      const Octant back{Vec{-o[0].x, -o[0].y}, Vec{-o[1].x, -o[1].y}};
      return leaves_along(one, other, o) || leaves_along(other, one, back);
    });
    if (either) return true;
    if (halvings == 0 || looks_ > looks_max) return false;
    cut(one);
    cut(other);
    const auto each = [](Patch& patch, const auto& holds) {
      return std::all_of(patch.parts.begin(), patch.parts.end(),
                         [&](std::optional<Patch>& part) { return !part || holds(*part); });
    };
    return each(one.patch, [&](Patch& a) {
      return each(other.patch, [&](Patch& b) {
        return they_part({one.cell, one.place, a}, {other.cell, other.place, b}, halvings - 1);
      });
    });
  }

  // Of the places in two cells those in the midst of all from which neither leaves, where a little
  // to either side makes no difference; or else of those across a passage, or in cells beside the
  // two. Else the middles of the cells.
  Parting stuck_in(int one, int other) {
    if (const auto here = stuck_at(one, other, finely)) return *here;
    if (const auto across = stuck_across()) return *across;
    for (const auto& [by_one, by_other] : steps_aside()) {
      const int a = moved(one, by_one), b = moved(other, by_other);
      if (a < 0 || b < 0) continue;
      if (const auto beside = stuck_at(a, b, coarsely)) return *beside;
    }
    return {Parting::How::stuck, rounded(middle(one)), rounded(middle(other))};
  }
  std::optional<Parting> stuck_at(int one, int other, int each_way) {
    const auto all = stuck_places(one, other, each_way);
    if (all.empty()) return std::nullopt;
    const auto& [p, q] = midst_of(all);
    return Parting{Parting::How::stuck, rounded(p), rounded(q)};
  }
  // Before both walls of a passage, opposite to each other: whatever leads on leads first to where
  // ways are clear, between the two. The farthest first, which are nearest to the walls.
  std::optional<Parting> stuck_across() {
    constexpr int lengths = 4, tries_max = 500;
    int tries = 0;
    for (int shorter = 1; shorter <= lengths; ++shorter) {
      for (const auto& [columns, rows] : {Step{0, 1}, Step{1, 0}, Step{1, 1}, Step{-1, 1}}) {
        const double apart = query_.apart_mm / (size_ * std::hypot(columns, rows));
        const int many = static_cast<int>(apart) - shorter;
        if (many < 2) continue;
        for (int one = 0; index(one) < places_.size(); ++one) {
          const int other = moved(one, {many * columns, many * rows});
          const int between = moved(one, {many / 2 * columns, many / 2 * rows});
          if (other < 0 || !may_be_clear(between) || may_be_clear(one) || may_be_clear(other) ||
              !holds_somebody(one) || !holds_somebody(other))
            continue;
          if (++tries > tries_max) return std::nullopt;
          if (stuck_places(one, other, roughly).empty()) continue;
          if (auto stuck = stuck_at(one, other, coarsely)) return stuck;
        }
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] int moved(int cell, Step by) const {
    const int c = column(cell) + by.columns, r = row(cell) + by.rows;
    const bool on_grid = c >= 0 && r >= 0 && c < cells_.columns && r < cells_.rows;
    return on_grid ? r * cells_.columns + c : -1;
  }
  std::vector<std::array<Vec, 2>> stuck_places(int one, int other, int each_way) {
    std::vector<std::array<Vec, 2>> all;
    std::vector<Patch> others = places_in(other, each_way);
    for (Patch& a : places_in(one, each_way)) {
      for (Patch& b : others) {
        const Box here = box_of(a.spot), there = box_of(b.spot);
        if (is_beyond(here.middle, {there.middle, 0}, query_.apart_mm)) continue;
        if (!is_beyond(here.middle, {there.middle, 0}, query_.nearest_mm)) continue;
        if (++placed_ > placed_max) return all;
        if (may_leave(one, a, {other, place(other), b})) continue;
        if (may_leave(other, b, {one, place(one), a})) continue;
        all.push_back({here.middle, there.middle});
      }
    }
    return all;
  }
  // Places of 1 mm in rows, where a robot can be put.
  std::vector<Patch> places_in(int cell, int each_way) {
    const double apart = size_ / each_way;
    const Vec m = middle(cell), first{m.x - (size_ - apart) / 2, m.y - (size_ - apart) / 2};
    std::vector<Patch> all;
    for (int row = 0; row < each_way; ++row) {
      for (int column = 0; column < each_way; ++column) {
        const Vec at{first.x + column * apart, first.y + row * apart};
        if (stands_.holds_nobody(stands_.look_around(at.x - 0.5, at.y - 0.5, 1, 0))) continue;
        all.push_back(Patch{{at.x, at.y, 1, 0}, {}});
      }
    }
    return all;
  }
  // As the search looks.
  bool may_leave(int cell, const Patch& one, Robot other) {
    const Box here = box_of(one.spot), there = box_of(other.patch.spot);
    if (is_clear(cell) && recedes(middle(cell), here, there) && leads(cell, other)) return true;
    std::optional<Connectors::Spot> spot;
    const auto sees = [&](Vec c) {
      const double half = one.spot.side_mm / 2;
      if (!spot) {
        spot = sights_.look_around(here.middle.x - half, here.middle.y - half, one.spot.side_mm,
                                   farthest_cells * size_ * std::sqrt(2.0));
      }
      return sights_.is_sound(*spot, {c.x, c.y, 0});
    };
    const auto goes = [&](int to) {
      return may_be_clear(to) && !comes_nearer(middle(to), here, there) && leads(to, other) &&
             sees(middle(to));
    };
    if (std::ranges::any_of(place(cell).landings, goes)) return true;  // mostly
    if (std::ranges::any_of(place(cell).far, goes)) return true;
    bool does = false;
    around(cell, farthest_cells * size_, [&](int to) { does = does || goes(to); });
    return does;
  }

  // From wherever the one stands in its patch, the search finds a way for it.
  bool leaves(Robot one, Robot other, int halvings) {
    const Box here = box_of(one.patch.spot), there = box_of(other.patch.spot);
    if (farthest_squared(here, there) < squared(query_.nearest_mm)) return true;
    if (some_leg(one, other, [&](Vec c) { return recedes(c, here, there); })) return true;
    const Octants off = octants(here, there);
    if (std::all_of(off.begin(), off.end(),
                    [&](const Octant& o) { return leaves_along(one, other, o); })) {
      return true;
    }
    if (halvings == 0 || looks_ > looks_max) return false;
    cut(one);
    return std::all_of(one.patch.parts.begin(), one.patch.parts.end(),
                       [&](std::optional<Patch>& part) {
                         return !part || leaves({one.cell, one.place, *part}, other, halvings - 1);
                       });
  }
  bool leaves_along(Robot one, Robot other, const Octant& off) {
    const Box here = box_of(one.patch.spot);
    return some_leg(one, other, [&](Vec c) { return recedes(c, here, off); });
  }
  // The search begins with its own cell, and with all within reach where that leads to nothing.
  bool leads_if_joined(int cell, Robot one, Robot other) {
    return leads(cell, other) ||
           comes_nearer(middle(cell), box_of(one.patch.spot), box_of(other.patch.spot));
  }
  template <class Good>
  bool some_leg(Robot one, Robot other, const Good& is_good) {
    const auto& [cell, place, patch] = one;
    const auto does = [&](int to) {
      ++looks_;
      return is_clear(to) && is_good(middle(to)) && leads(to, other);
    };
    if (patch.last >= 0 && does(patch.last)) return true;
    const auto found = std::find_if(patch.sound.begin(), patch.sound.end(), does);
    if (found != patch.sound.end()) {
      patch.last = *found;
      return true;
    }
    if (!by_all_legs_) return false;
    for (std::size_t i = 0; i < place.grazing.size(); ++i) {
      if (!does(place.grazing[i])) continue;
      if (is_sound_from(place, patch, place.grazing, patch.grazing, i)) return true;
    }
    return some_far_leg(one, other, does);
  }
  // The search begins with the nearest cell that it joins to: with this one, or with one that is
  // nearer. Of those that may be, all are among the landings unless this is one of the farthest.
  template <class Does>
  bool some_far_leg(Robot one, Robot other, const Does& does) {
    const auto& [cell, place, patch] = one;
    const Box here = box_of(patch.spot);
    const Vec m = middle(cell);
    // from there on one may lead back; of those that are farther off not yet looked at
    double back_mm = far_mm_;
    const auto look_at = [&](int to) {
      ++looks_;
      const double off_mm = std::sqrt(nearest_squared(middle(to), here));
      if (off_mm < back_mm && !leads_if_joined(to, one, other)) back_mm = off_mm;
    };
    std::size_t next = 0;
    for (std::size_t i = 0; i < place.far.size(); ++i) {
      const int to = place.far[i];
      if (squared_off(to, m) > squared(back_mm + size_)) return false;
      if (!does(to)) continue;
      const double reach_mm = std::sqrt(farthest_squared({middle(to), 0}, here));
      if (next == 0) std::ranges::for_each(place.landings, look_at);
      while (next < place.far.size() &&
             squared_off(place.far[next], m) <= squared(reach_mm + size_)) {
        look_at(place.far[next++]);
      }
      if (reach_mm + size_ > far_mm_ || reach_mm >= back_mm) continue;
      if (is_sound_from(place, patch, place.far, patch.far, i)) return true;
    }
    return false;
  }
  bool is_sound_from(const Place& p, const Patch& patch, const std::vector<int>& cells,
                     std::vector<std::optional<bool>>& known, std::size_t i) {
    known.resize(cells.size());
    if (!known[i]) known[i] = is_sound(p, patch.spot, cells[i]);
    return *known[i];
  }

  // From the middle of a cell, if ways lead over that, one leads to a goal, receding step by step
  // from every place of the other one's patch.
  bool leads(int cell, Robot other) {
    if (!other.patch.ways) other.patch.ways = ways_from(other);
    Ways& ways = *other.patch.ways;
    const std::optional<std::size_t> slot = slot_around(other.cell, cell);
    if (slot && ways.asked[*slot]) return ways.lead[*slot];  // mostly
    return leads_on(cell, other.cell, box_of(other.patch.spot), ways);
  }
  // How many cells are around one.
  [[nodiscard]] std::size_t squared_window() const {
    return index(2 * window_ + 1) * index(2 * window_ + 1);
  }
  std::shared_ptr<Ways> ways_from(Robot other) {
    const Box there = box_of(other.patch.spot);
    const Vec m = middle(other.cell);
    auto& known = known_ways_[{static_cast<double>(alike_.surroundings(other.cell)), there.half,
                               there.middle.x - m.x, there.middle.y - m.y}];
    if (!known) {
      const std::size_t count = squared_window();
      looks_ += static_cast<std::int64_t>(count) / 64;
      known = std::make_shared<Ways>(Ways{std::vector<bool>(count), std::vector<bool>(count)});
    }
    return known;
  }
  // Step by step, and from where no way goes on, back to the last place before it. Each step leads
  // farther off, so that no way comes back to where it has been.
  bool leads_on(int cell, int there, const Box& other, Ways& ways) {
    std::vector<std::pair<int, std::size_t>> way{{cell, 0}};  // with the steps that have been tried
    bool lead = false;
    while (!way.empty() && !lead) {
      auto& [at, tried] = way.back();
      const std::optional<std::size_t> slot = slot_around(there, at);
      // beyond the window all are goals
      lead = !slot ||
             (ways.asked[*slot] ? ways.lead[*slot] : is_beyond(middle(at), other, query_.goal_mm));
      if (lead) break;
      while (!ways.asked[*slot] && tried < steps.size() && !steps_off(at, tried, other)) ++tried;
      if (ways.asked[*slot] || tried == steps.size()) {
        ways.asked[*slot] = true;
        way.pop_back();
        continue;
      }
      const auto [columns, rows] = steps[tried++];
      looks_ += 8;
      way.emplace_back(at + rows * cells_.columns + columns, 0);
    }
    for (const auto& [at, tried] : way) {
      const std::optional<std::size_t> slot = slot_around(there, at);
      if (slot) ways.asked[*slot] = ways.lead[*slot] = true;
    }
    return lead;
  }
  // Where a cell is among those around one.
  [[nodiscard]] std::optional<std::size_t> slot_around(int there, int cell) const {
    const int c = column(cell) - column(there) + window_, r = row(cell) - row(there) + window_;
    const int width = 2 * window_ + 1;
    if (c < 0 || r < 0 || c >= width || r >= width) return std::nullopt;
    return index(r * width + c);
  }
  // Such a step leads on from there, and recedes from all of the box.
  [[nodiscard]] bool steps_off(int cell, std::size_t i, const Box& other) const {
    if ((steps_[index(cell)] >> i & 1) == 0) return false;
    const Vec from = middle(cell), step{steps[i].columns * size_, steps[i].rows * size_};
    const double x = from.x - other.middle.x, y = from.y - other.middle.y;
    return recedes(step.x * x - other.half * std::abs(step.x),
                   step.y * y - other.half * std::abs(step.y));
  }

  const std::vector<EdgeRow>& edges_;
  const CellGrid& cells_;
  const PartingQuery& query_;
  const double size_;
  const double far_mm_;  // from the middle of a cell to what the search may join to from there
  const int window_;     // cells to each side of one, up to where ways from it end
  const Unsure unsure_;
  const ClearCells clear_, may_be_clear_;
  const Alike alike_;
  Connectors stands_;                                // where a robot is put
  Connectors sights_;                                // and what it may go to from there
  std::vector<std::optional<bool>> holds_somebody_;  // by kinds, as far as that has been asked
  std::vector<Place> places_;
  std::vector<std::uint8_t> steps_;
  std::vector<std::uint8_t> clearings_;  // by cells
  std::vector<std::uint64_t> known_ = std::vector<std::uint64_t>(std::size_t{1} << known_bits, 0);
  // Where as much is clear around a cell, the same ways lead away from it: by that, and by how wide
  // and where in its cell a part of it is.
  std::map<std::array<double, 4>, std::shared_ptr<Ways>> known_ways_;
  bool by_all_legs_ = false;
  int placed_ = 0;
  std::int64_t looks_ = 0;
};

}  // namespace

Parting parting(const std::vector<EdgeRow>& edges, const CellGrid& cells,
                const PartingQuery& query) {
  thread_local Kept<std::pair<Drawn, PartingQuery>, Parting> kept;
  return kept.find({Drawn(edges, cells), query}, [&] {
    const Unsure unsure = query.off_grid ? off_the_grid : Unsure{};
    const Parting found = Search(edges, cells, query, unsure).run();
    if (found.how != Parting::How::stuck || unsure.clearance_mm == 0) return found;
    // a run begins where they are stuck as robots know the cells, if they are anywhere
    const Parting known = Search(edges, cells, query, {}).run();
    return known.how == Parting::How::stuck ? known : found;
  });
}

}  // namespace rtac::geometry
