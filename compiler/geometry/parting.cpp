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
constexpr std::int64_t looks_max = 800'000'000;
// So many pairs that part are remembered, as a power of 2.
constexpr int known_bits = 20;
// Cells that ways are remembered of: of two bits each, 200 MB.
constexpr std::size_t known_ways_max = 800'000'000;

class Search {
 public:
  Search(const std::vector<EdgeRow>& edges, const CellGrid& cells, const PartingQuery& query)
      : edges_(edges),
        cells_(cells),
        query_(query),
        size_(cells.cell_mm),
        far_mm_(std::min(1.5 * query.clearance_mm + 4 * size_ + 400, far_cells_max * size_)),
        window_(static_cast<int>(std::ceil(query.goal_mm / size_)) + 3),
        clear_(cells, query.clearance_mm),
        alike_(cells, clear_, Connectors(edges, query.clearance_mm, query.body_mm), around_cells(),
               far_mm_),
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
    std::vector<std::optional<bool>> far{};  // the same of those farther off, once it is asked for
    std::vector<std::optional<Patch>> parts{};  // none: no body can be there
    int last = -1;  // the leg that did for one place of the other robot: often for the next, too
    std::shared_ptr<Ways> ways{};
  };
  struct Place {
    bool looked_at = false;
    std::vector<int> landings;               // the search joins to all of them,
    std::vector<int> far;                    // or else to the nearest one of these: by distance
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
  [[nodiscard]] double squared_off(int cell, Vec p) const {
    return squared(middle(cell).x - p.x) + squared(middle(cell).y - p.y);
  }
  static GridPoint rounded(Vec p) {
    return {static_cast<std::int32_t>(std::lround(p.x)),
            static_cast<std::int32_t>(std::lround(p.y))};
  }
  // Ways lead over it.
  [[nodiscard]] bool is_clear(int cell) const { return clear_.at(column(cell), row(cell)); }
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
  [[nodiscard]] Clearings clearings_of() const {
    return {size_, static_cast<double>(query_.goal_mm), landing_reach_mm()};
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
      if (!is_clear(to)) return;
      const double off_mm = std::hypot(middle(to).x - m.x, middle(to).y - m.y);
      if (off_mm <= reach_mm) {
        p.landings.push_back(to);
      } else if (off_mm <= far_mm_ && !is_clear(cell)) {
        p.far.push_back(to);
      }
    });
    std::ranges::stable_sort(p.far, {}, [&](int to) { return squared_off(to, m); });
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
    Patch patch{spot, {}};
    std::ranges::copy_if(p.landings, std::back_inserter(patch.sound),
                         [&](int to) { return is_sound(p, spot, to); });
    return patch;
  }
  bool is_sound(const Place& p, const Connectors::Spot& spot, int to) {
    looks_ += 10;
    return p.connectors->is_sound(spot, {middle(to).x, middle(to).y, 0});
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

  bool they_part(int one, int other) {
    if (!place(one).patch || !place(other).patch) return true;  // nobody is there
    const Robot a{one, place(one), *place(one).patch}, b{other, place(other), *place(other).patch};
    by_far_cells_ = false;  // mostly
    const bool near_do = !a.place.landings.empty() || !b.place.landings.empty();
    if (near_do && they_part(a, b, halvings_of_both_max)) return true;
    by_far_cells_ = true;
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

  // Of the places in two cells that ways lead over from which both set out over the middles of
  // these alone, and neither way leads on: those in the midst of all, where a little to either side
  // makes no difference. Else the middles of the cells.
  Parting stuck_in(int one, int other) {
    std::vector<std::array<Vec, 2>> all;
    const bool both_clear = is_clear(one) && is_clear(other);
    const std::vector<Patch> places = both_clear ? places_in(one) : std::vector<Patch>{};
    std::vector<Patch> others = both_clear ? places_in(other) : std::vector<Patch>{};
    for (Patch a : places) {
      for (Patch& b : others) {
        const Box here = box_of(a.spot), there = box_of(b.spot);
        const Box both{there.middle, here.half + there.half};
        const bool near = !is_beyond(here.middle, both, query_.apart_mm);
        const bool join = recedes(middle(one), here, there) && recedes(middle(other), there, here);
        if (!near || !join) continue;
        if (leads(one, {other, place(other), b}) || leads(other, {one, place(one), a})) continue;
        all.push_back({here.middle, there.middle});
      }
    }
    if (all.empty()) return {Parting::How::stuck, rounded(middle(one)), rounded(middle(other))};
    std::array<Vec, 2> mean{};
    for (const auto& pair : all) {
      for (std::size_t i = 0; i < 2; ++i) {
        mean[i].x += pair[i].x / static_cast<double>(all.size());
        mean[i].y += pair[i].y / static_cast<double>(all.size());
      }
    }
    const auto& midst = *std::ranges::min_element(all, {}, [&](const std::array<Vec, 2>& pair) {
      return squared(pair[0].x - mean[0].x) + squared(pair[0].y - mean[0].y) +
             squared(pair[1].x - mean[1].x) + squared(pair[1].y - mean[1].y);
    });
    return {Parting::How::stuck, rounded(midst[0]), rounded(midst[1])};
  }
  // In rows, each of 1 mm.
  [[nodiscard]] std::vector<Patch> places_in(int cell) const {
    constexpr int each_way = 16;
    const double apart = size_ / each_way;
    const Vec m = middle(cell), first{m.x - (size_ - apart) / 2, m.y - (size_ - apart) / 2};
    std::vector<Patch> all;
    for (int row = 0; row < each_way; ++row) {
      for (int column = 0; column < each_way; ++column) {
        all.push_back(Patch{{first.x + column * apart, first.y + row * apart, 1, 0}, {}});
      }
    }
    return all;
  }

  // From wherever the one stands in its patch, the search finds a way for it.
  bool leaves(Robot one, Robot other, int halvings) {
    const Box here = box_of(one.patch.spot), there = box_of(other.patch.spot);
    if (farthest_squared(here, there) < squared(query_.nearest_mm)) return true;
    if (begins(one, other) &&
        some_leg(one, other, [&](Vec c) { return recedes(c, here, there); })) {
      return true;
    }
    const Octants off = octants(here, there);
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
    if (!by_far_cells_) return false;
    patch.far.resize(place.far.size());
    for (std::size_t i = 0; i < place.far.size(); ++i) {
      const int to = place.far[i];
      ++looks_;
      if (!is_good(middle(to)) || !all_lead_up_to(to, one, other)) continue;
      if (!patch.far[i]) patch.far[i] = is_sound(place, patch.spot, to);
      if (*patch.far[i]) return true;
    }
    return false;
  }
  // The search begins with the nearest cell that it joins to: with this one, or with one that is
  // nearer. Of those that may be, all are among the landings unless this is one of the farthest.
  bool all_lead_up_to(int landing, Robot one, Robot other) {
    const Box here = box_of(one.patch.spot);
    const double reach_mm = std::sqrt(farthest_squared({middle(landing), 0}, here));
    if (reach_mm + size_ > far_mm_) return false;
    const auto may_lead_back = [&](int to) {
      ++looks_;
      return !is_beyond(middle(to), here, reach_mm) && !leads_if_joined(to, one, other);
    };
    const Vec m = middle(one.cell);
    const double farthest = squared(reach_mm + size_);  // from there none is nearer to the patch
    const auto& far = one.place.far;
    const auto end = std::ranges::find_if(
        far, [&](int to) { return squared_off(to, m) > farthest || may_lead_back(to); });
    return (end == far.end() || squared_off(*end, m) > farthest) &&
           std::ranges::none_of(one.place.landings, may_lead_back);
  }

  // From the middle of a cell that ways lead over one leads to a goal, receding step by step from
  // every place of the other one's patch.
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
  const ClearCells clear_;
  const Alike alike_;
  std::vector<std::optional<bool>> holds_somebody_;  // by kinds, as far as that has been asked
  std::vector<Place> places_;
  std::vector<std::uint8_t> steps_;
  std::vector<std::uint8_t> clearings_;  // by cells
  std::vector<std::uint64_t> known_ = std::vector<std::uint64_t>(std::size_t{1} << known_bits, 0);
  // Where as much is clear around a cell, the same ways lead away from it: by that, and by how wide
  // and where in its cell a part of it is.
  std::map<std::array<double, 4>, std::shared_ptr<Ways>> known_ways_;
  bool by_far_cells_ = false;
  std::int64_t looks_ = 0;
};

}  // namespace

Parting parting(const std::vector<EdgeRow>& edges, const CellGrid& cells,
                const PartingQuery& query) {
  thread_local Kept<std::pair<Drawn, PartingQuery>, Parting> kept;
  return kept.find({Drawn(edges, cells), query}, [&] { return Search(edges, cells, query).run(); });
}

}  // namespace rtac::geometry
