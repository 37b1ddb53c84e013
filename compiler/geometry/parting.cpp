#include "compiler/geometry/parting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>

#include "compiler/geometry/connectors.h"
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
constexpr std::int64_t looks_max = 800'000'000;
struct Step {
  int columns, rows;
};
constexpr std::array<Step, 8> steps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

class Search {
 public:
  Search(const std::vector<EdgeRow>& edges, const CellGrid& cells, const PartingQuery& query)
      : edges_(edges),
        cells_(cells),
        query_(query),
        size_(cells.cell_mm),
        far_mm_(std::min(1.5 * query.clearance_mm + 4 * size_ + 400, far_cells_max * size_)),
        window_(static_cast<int>(std::ceil(query.goal_mm / size_)) + 3),
        places_(cells.clearance_mm_lo.size()) {
    for (int cell = 0; index(cell) < places_.size(); ++cell) steps_.push_back(steps_from(cell));
  }

  Parting run() {
    const int count = static_cast<int>(cells_.clearance_mm_lo.size());
    for (int one = 0; one < count; ++one) {
      if (is_outside(one) || !place(one).patch) continue;
      for (const int other : near(one)) {
        if (!place(other).patch) continue;
        const bool part = they_part(one, other, false) || they_part(one, other, true);
        if (looks_ > looks_max) return {Parting::How::too_large, {}, {}};
        if (!part) return {Parting::How::stuck, at(one), at(other)};
      }
    }
    return {};
  }

 private:
  // Of the cells around one, those from whose middles ways lead.
  struct Ways {
    int west = 0, south = 0;
    std::shared_ptr<const std::vector<bool>> lead;
  };
  // A part of a cell, which legs are sound from anywhere in it, and the ways of others when a robot
  // stands there.
  struct Patch {
    Connectors::Spot spot;
    std::vector<int> sound;
    std::optional<std::vector<int>> far{};  // the same of those farther off, once it is asked for
    std::vector<std::optional<Patch>> parts{};  // none: no body can be there
    int last = -1;  // the leg that did for one place of the other robot: often for the next, too
    std::optional<Ways> ways{};
  };
  struct Place {
    bool looked_at = false;
    int surroundings = -1;                   // number of what is clear around it
    std::vector<int> landings;               // the search joins to all of them,
    std::vector<int> far;                    // or else to the nearest one of these
    std::unique_ptr<Connectors> connectors;  // of a cell that is not clear enough for ways
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
  [[nodiscard]] GridPoint at(int cell) const {
    const Vec m = middle(cell);
    return {static_cast<std::int32_t>(m.x), static_cast<std::int32_t>(m.y)};
  }
  [[nodiscard]] bool is_outside(int cell) const { return cells_.clearance_mm_lo[index(cell)] < 0; }
  // Ways lead over it.
  [[nodiscard]] bool is_clear(int cell) const {
    return !is_outside(cell) && cells_.clearance_mm_lo[index(cell)] >= query_.clearance_mm;
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
    for (std::size_t i = 0; i < steps.size() && is_clear(cell); ++i) {
      const int c = column(cell) + steps[i].columns, r = row(cell) + steps[i].rows;
      if (c < 0 || r < 0 || c >= cells_.columns || r >= cells_.rows) continue;
      const bool passes = is_clear(r * cells_.columns + c) &&
                          is_clear(row(cell) * cells_.columns + c) &&
                          is_clear(r * cells_.columns + column(cell));
      if (passes) all = static_cast<std::uint8_t>(all | 1U << i);
    }
    return all;
  }
  // The cells from this one on of which some place is so near to one of its own.
  [[nodiscard]] std::vector<int> near(int cell) const {
    std::vector<int> all;
    const Vec m = middle(cell);
    around(cell, query_.apart_mm + size_, [&](int other) {
      if (other < cell || is_outside(other)) return;
      if (!is_beyond(middle(other), {m, size_}, query_.apart_mm)) all.push_back(other);
    });
    return all;
  }
  // All cells of the rectangle between two are those that ways lead over.
  [[nodiscard]] bool all_clear(int a, int b) {
    if (not_clear_.empty()) sum_up();
    const auto sum = [&](int c, int r) { return not_clear_[index(r * (cells_.columns + 1) + c)]; };
    const auto [west, east] = std::minmax({column(a), column(b)});
    const auto [south, north] = std::minmax({row(a), row(b)});
    return sum(east + 1, north + 1) - sum(west, north + 1) - sum(east + 1, south) +
               sum(west, south) ==
           0;
  }
  // Of the cells south-west of each corner, how many are not clear.
  void sum_up() {
    const int width = cells_.columns + 1;
    not_clear_.assign(index(width * (cells_.rows + 1)), 0);
    for (int r = 0; r < cells_.rows; ++r) {
      std::int32_t of_row = 0;
      for (int c = 0; c < cells_.columns; ++c) {
        of_row += is_clear(r * cells_.columns + c) ? 0 : 1;
        not_clear_[index((r + 1) * width + c + 1)] = not_clear_[index(r * width + c + 1)] + of_row;
      }
    }
  }

  Place& place(int cell) {
    Place& p = places_[index(cell)];
    if (p.looked_at) return p;
    p.looked_at = true;
    const Vec m = middle(cell);
    // what the search joins to from everywhere in the cell (connector_reach_m of grid_route), and
    // what it joins to when there is none of that: in a corner about as far off as ways are clear
    const double reach_mm = std::max(400.0, 2 * size_);
    around(cell, far_mm_, [&](int to) {
      if (!is_clear(to)) return;
      const double off_mm = std::hypot(middle(to).x - m.x, middle(to).y - m.y);
      if (off_mm <= reach_mm) {
        p.landings.push_back(to);
      } else if (off_mm <= far_mm_ && !is_clear(cell)) {
        p.far.push_back(to);
      }
    });
    if (is_clear(cell)) {
      // every place between is as clear as ways are
      std::erase_if(p.landings, [&](int to) { return !all_clear(cell, to); });
      p.patch = Patch{{m.x, m.y, size_, 0}, {}};
      p.patch->sound = p.landings;
      return p;
    }
    p.connectors = std::make_unique<Connectors>(edges_, query_.clearance_mm, query_.body_mm);
    p.patch =
        patch_of(p, p.connectors->look_around(m.x - size_ / 2, m.y - size_ / 2, size_, far_mm_));
    return p;
  }
  std::optional<Patch> patch_of(const Place& p, const Connectors::Spot& spot) {
    if (p.connectors->holds_nobody(spot)) return std::nullopt;
    return Patch{spot, sound_of(p, spot, p.landings)};
  }
  std::vector<int> sound_of(const Place& p, const Connectors::Spot& spot,
                            const std::vector<int>& landings) {
    looks_ += static_cast<std::int64_t>(landings.size()) * 10;
    std::vector<int> sound;
    std::copy_if(landings.begin(), landings.end(), std::back_inserter(sound), [&](int to) {
      return p.connectors->is_sound(spot, {middle(to).x, middle(to).y, 0});
    });
    return sound;
  }
  void cut(const Place& p, Patch& patch) {
    if (!patch.parts.empty()) return;
    const double off = patch.spot.side_mm / 4, half = patch.spot.side_mm / 2;
    if (p.connectors) {
      for (const Connectors::Spot& part : p.connectors->quarters(patch.spot)) {
        patch.parts.push_back(patch_of(p, part));
      }
      return;
    }
    for (const double y : {-off, off}) {
      for (const double x : {-off, off}) {
        patch.parts.emplace_back(
            Patch{{patch.spot.x_mm + x, patch.spot.y_mm + y, half, 0}, patch.sound});
      }
    }
  }

  bool they_part(int one, int other, bool by_far_cells) {
    by_far_cells_ = by_far_cells;
    return they_part({one, place(one), *place(one).patch},
                     {other, place(other), *place(other).patch}, halvings_of_both_max);
  }
  // From wherever the two stand in their patches, a way is sure to be found for one of them.
  bool they_part(Robot one, Robot other, int halvings) {
    const Box here = box_of(one.patch.spot), there = box_of(other.patch.spot);
    if (farthest_squared(here, there) < squared(query_.nearest_mm)) return true;
    const Box both{there.middle, here.half + there.half};
    if (is_beyond(here.middle, both, query_.apart_mm)) return true;
    if (leaves(one, other, 0) || leaves(other, one, 0)) return true;  // mostly
    if (leaves(one, other, halvings_max) || leaves(other, one, halvings_max)) return true;
    const std::vector<Octant> off = octants(here, there);
    const bool either = std::all_of(off.begin(), off.end(), [&](const Octant& o) {
      const Octant back{Vec{-o[0].x, -o[0].y}, Vec{-o[1].x, -o[1].y}};
      return leaves_along(one, other, o) || leaves_along(other, one, back);
    });
    if (either) return true;
    if (halvings == 0 || looks_ > looks_max) return false;
    cut(one.place, one.patch);
    cut(other.place, other.patch);
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

  // From wherever the one stands in its patch, the search finds a way for it.
  bool leaves(Robot one, Robot other, int halvings) {
    const Box here = box_of(one.patch.spot), there = box_of(other.patch.spot);
    if (farthest_squared(here, there) < squared(query_.nearest_mm)) return true;
    if (begins(one, other) &&
        some_leg(one, other, [&](Vec c) { return recedes(c, here, there); })) {
      return true;
    }
    const std::vector<Octant> off = octants(here, there);
    if (std::all_of(off.begin(), off.end(),
                    [&](const Octant& o) { return leaves_along(one, other, o); })) {
      return true;
    }
    if (halvings == 0 || looks_ > looks_max) return false;
    cut(one.place, one.patch);
    return std::all_of(one.patch.parts.begin(), one.patch.parts.end(),
                       [&](std::optional<Patch>& part) {
                         return !part || leaves({one.cell, one.place, *part}, other, halvings - 1);
                       });
  }
  bool leaves_along(Robot one, Robot other, const Octant& off) {
    const Box here = box_of(one.patch.spot);
    if (!begins(one, other) && !comes_nearer(middle(one.cell), here, off)) return false;
    return some_leg(one, other, [&](Vec c) { return recedes(c, here, off); });
  }
  // Where its own cell is clear enough and the leg to the middle of that recedes, the search begins
  // with that alone.
  bool begins(Robot one, Robot other) {
    return one.place.connectors != nullptr || leads_if_joined(one.cell, one, other);
  }
  bool leads_if_joined(int cell, Robot one, Robot other) {
    return leads(cell, other) ||
           comes_nearer(middle(cell), box_of(one.patch.spot), box_of(other.patch.spot));
  }
  template <class Good>
  bool some_leg(Robot one, Robot other, const Good& is_good) {
    const auto& [cell, place, patch] = one;
    const auto does = [&](int to) {
      ++looks_;
      return is_good(middle(to)) && leads(to, other);
    };
    if (patch.last >= 0 && does(patch.last)) return true;
    const auto found = std::find_if(patch.sound.begin(), patch.sound.end(), does);
    if (found != patch.sound.end()) {
      patch.last = *found;
      return true;
    }
    if (!by_far_cells_ || place.far.empty()) return false;
    if (!patch.far) patch.far = sound_of(place, patch.spot, place.far);
    looks_ += static_cast<std::int64_t>(patch.far->size());
    return std::any_of(patch.far->begin(), patch.far->end(), [&](int to) {
      return is_good(middle(to)) && all_lead_up_to(to, one, other);
    });
  }
  // The search begins with the nearest cell that it joins to: with this one, or with one that is
  // nearer. Of those that may be, all are among the landings unless this is one of the farthest.
  bool all_lead_up_to(int landing, Robot one, Robot other) {
    const Box here = box_of(one.patch.spot);
    const double reach_mm = std::sqrt(farthest_squared({middle(landing), 0}, here));
    if (reach_mm + size_ > far_mm_) return false;
    const auto all_lead = [&](const std::vector<int>& cells) {
      return std::all_of(cells.begin(), cells.end(), [&](int to) {
        return is_beyond(middle(to), here, reach_mm) || leads_if_joined(to, one, other);
      });
    };
    return all_lead(one.place.landings) && all_lead(one.place.far);
  }

  // Beyond the window every cell that ways lead over is a goal.
  [[nodiscard]] bool leads(int cell, Robot other) {
    return lead_on(ways_from(other), cell).value_or(true);
  }
  const Ways& ways_from(Robot other) {
    std::optional<Ways>& ways = other.patch.ways;
    if (ways) return *ways;
    const int west = column(other.cell) - window_, south = row(other.cell) - window_;
    const Box there = box_of(other.patch.spot);
    if (other.place.surroundings < 0) {
      other.place.surroundings =
          surroundings_.emplace(clear_around(other.cell), static_cast<int>(surroundings_.size()))
              .first->second;
    }
    const Vec m = middle(other.cell);
    auto& lead = known_ways_[{static_cast<double>(other.place.surroundings), there.half,
                              there.middle.x - m.x, there.middle.y - m.y}];
    if (!lead) lead = std::make_shared<const std::vector<bool>>(find_ways(other.cell, there));
    ways = Ways{west, south, lead};
    return *ways;
  }
  // Where as much is clear around a cell, the same ways lead away from it.
  [[nodiscard]] std::vector<bool> clear_around(int cell) {
    std::vector<bool> all;
    looks_ += std::int64_t{2} * window_ * window_;
    for (int r = row(cell) - window_; r <= row(cell) + window_; ++r) {
      for (int c = column(cell) - window_; c <= column(cell) + window_; ++c) {
        const bool in_grid = c >= 0 && r >= 0 && c < cells_.columns && r < cells_.rows;
        all.push_back(in_grid && is_clear(r * cells_.columns + c));
      }
    }
    return all;
  }
  // none: too far off.
  [[nodiscard]] std::optional<bool> lead_on(const Ways& ways, int cell) const {
    const int c = column(cell) - ways.west, r = row(cell) - ways.south, width = 2 * window_ + 1;
    if (c < 0 || r < 0 || c >= width || r >= width) return std::nullopt;
    return (*ways.lead)[index(r * width + c)];
  }
  // Backwards from the goals: the cells from whose middles ways recede step by step from every
  // place of the box.
  std::vector<bool> find_ways(int there, const Box& other) {
    const int width = 2 * window_ + 1, west = column(there) - window_, south = row(there) - window_;
    std::vector<bool> lead(index(width * width), false);
    const auto mark = [&](int cell) {
      const int c = column(cell) - west, r = row(cell) - south;
      if (c < 0 || r < 0 || c >= width || r >= width) return false;
      std::vector<bool>::reference known = lead[index(r * width + c)];
      const bool news = !known;
      known = true;
      return news;
    };
    std::vector<int> open;
    around(there, window_ * size_, [&](int cell) {
      ++looks_;
      const bool is_goal = is_clear(cell) && is_beyond(middle(cell), other, query_.goal_mm);
      if (is_goal && mark(cell)) open.push_back(cell);
    });
    while (!open.empty()) {
      const int to = open.back();
      open.pop_back();
      const Vec end = middle(to);
      looks_ += 8;
      for (std::size_t i = 0; i < steps.size(); ++i) {
        if ((steps_[index(to)] >> i & 1) == 0) continue;
        // backwards: the step leads on from there, and recedes from all of the box
        const auto [columns, rows] = steps[i];
        const Vec step{-columns * size_, -rows * size_};
        const Vec off{end.x - step.x - other.middle.x, end.y - step.y - other.middle.y};
        if (!recedes(step.x * off.x - other.half * std::abs(step.x),
                     step.y * off.y - other.half * std::abs(step.y))) {
          continue;
        }
        const int from = to + rows * cells_.columns + columns;
        if (mark(from)) open.push_back(from);
      }
    }
    return lead;
  }

  const std::vector<EdgeRow>& edges_;
  const CellGrid& cells_;
  const PartingQuery& query_;
  const double size_;
  const double far_mm_;  // from the middle of a cell to what the search may join to from there
  const int window_;     // cells to each side of one, up to where ways from it end
  std::vector<Place> places_;
  std::vector<std::uint8_t> steps_;
  std::vector<std::int32_t> not_clear_;
  std::map<std::vector<bool>, int> surroundings_;  // their numbers, by which cells are clear
  // By those, and by how wide and where in its cell a part of it is.
  std::map<std::array<double, 4>, std::shared_ptr<const std::vector<bool>>> known_ways_;
  bool by_far_cells_ = false;
  std::int64_t looks_ = 0;
};

}  // namespace

Parting parting(const std::vector<EdgeRow>& edges, const CellGrid& cells,
                const PartingQuery& query) {
  return Search(edges, cells, query).run();
}

}  // namespace rtac::geometry
