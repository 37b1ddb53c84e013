#include "compiler/recheck/joining.h"

#include <algorithm>
#include <cmath>

#include "compiler/recheck/legs.h"

namespace rtac::recheck {
namespace {

// A cell with a way on.
struct Start {
  Place place;
  double clearance, rest;
  bool tried;  // a leg straight to it is looked at, if that is where the way ends
};

class Joins {
 public:
  Joins(const std::vector<Segment>& zone, const Grid& grid, const JoiningLimits& limits)
      : zone_(zone),
        grid_(grid),
        limits_(limits),
        columns_(static_cast<int>(grid.columns)),
        rows_(static_cast<int>(grid.rows)),
        all_lead_on_(std::ranges::none_of(limits.rest, [](double rest) { return rest < 0; })) {}

  Joining run() {
    Joining found;
    found.from.resize(grid_.clearance.size(), -1);
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (clearance(column, row) >= enough() + grid_.less) continue;
        if (limits_.of && !limits_.of(index(column, row))) continue;
        auto way = longest_from(column, row);
        if (!way && limits_.straight) way = limits_.straight(index(column, row));
        if (!way) {
          found.apart = index(column, row);
          return found;
        }
        found.longest = std::max(found.longest, *way);
        found.from[index(column, row)] = *way;
      }
    }
    return found;
  }

 private:
  // The search tries so many cells, ring by ring.
  static constexpr int tests_max = 2000, quarters_max = 7;
  // It forgives 8 mm, of which one may be lost to the grid.
  static constexpr double forgiven_m = 0.007;
  // Straight to the end of a way it forgives 2 mm; all of the cells in so many rings are tried.
  static constexpr double straight_forgiven_m = 0.0015;
  static constexpr int rings_surely = 21;
  static constexpr std::int64_t steps_max = 60'000'000, of_cell_max = 600'000;

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * grid_.columns + static_cast<std::size_t>(column);
  }
  [[nodiscard]] double clearance(int column, int row) const {
    return grid_.clearance[index(column, row)];
  }
  [[nodiscard]] Box box(int column, int row) const {
    return grid_.box(static_cast<std::size_t>(column), static_cast<std::size_t>(row), 1);
  }
  // What a way asks of its cells at most: from where there is more, control is given back.
  [[nodiscard]] double enough() const {
    return limits_.as_clear_as_here ? std::min(limits_.route, limits_.back) : limits_.route;
  }
  static double apart(Place a, Place b) { return length(a.x - b.x, a.y - b.y); }

  std::optional<double> longest_from(int column, int row) {
    const Box here = box(column, row);
    steps_ += static_cast<std::int64_t>(zone_.size());
    const double around = 2 * grid_.cell +
                          std::max({limits_.route, limits_.body, limits_.back + 2 * table_m}) +
                          snap_m;
    if (Boundary(zone_, middle(here), around).holds_nobody(here, limits_.body)) return 0.0;
    without_.reset();
    steps_end_ = std::min(steps_max, steps_ + of_cell_max);
    for (const std::size_t enough : {std::size_t{16}, std::size_t{80}, std::size_t{tests_max}}) {
      const std::vector<Start> starts = starts_of(column, row, enough);
      double far = 0;
      for (const Start& s : starts) far = std::max(far, apart(s.place, middle(here)));
      steps_ += static_cast<std::int64_t>(zone_.size());
      const Boundary boundary(zone_, middle(here), far + around);
      // from where none of the nearer ones did, mostly no other does
      if (without_ && first_of(boundary, *without_, starts) == nullptr) continue;
      if (const auto way = way_from(boundary, here, starts, quarters_max)) return way;
      if (starts.size() < enough || steps_ > steps_end_) break;
    }
    return std::nullopt;
  }
  // The longest of the shortest ways, as far as they are found; nullopt: from some place none is.
  std::optional<double> way_from(const Boundary& boundary, const Box& from,
                                 const std::vector<Start>& starts, int times) {
    if (boundary.holds_nobody(from, limits_.body)) return 0.0;
    const double given_back = limits_.back + std::max(grid_.less, slack_m);
    const double most = given_back + 2 * radius(from);  // no more of the clearance matters
    if (limits_.as_clear_as_here && boundary.asked_from(from, most, 0) >= most) return 0.0;
    if (const Start* const s = first_of(boundary, from, starts)) {
      const double leg = leg_to(from, *s);
      // of all in reach the best one is taken
      if (leg <= limits_.reach - grid_.cell / 5) return leg + s->rest;
      const double least = clear_for(boundary, from) - 2 * radius(from) - table_m;
      return std::min(leg + rest_within(from, leg, least), straight(boundary, from, starts));
    }
    if (times == 0 || steps_ > steps_end_) {
      without_ = from;
      return std::nullopt;
    }
    double longest = 0;
    for (const Box& quarter : quarters(from)) {
      const auto way = way_from(boundary, quarter, starts, times - 1);
      if (!way) return std::nullopt;
      longest = std::max(longest, *way);
    }
    return longest;
  }
  // What the cells have to be clear by for all of the square.
  [[nodiscard]] double clear_for(const Boundary& boundary, const Box& from) const {
    return limits_.as_clear_as_here ? boundary.asked_from(from, limits_.route, 0) : limits_.route;
  }
  const Start* first_of(const Boundary& boundary, const Box& from,
                        const std::vector<Start>& starts) {
    const double asked = boundary.asked_from(from, limits_.route, forgiven_m);
    const double clear = std::min(clear_for(boundary, from), enough()) + grid_.less;
    for (const Start& s : starts) {
      if (s.clearance < clear) continue;
      // beyond the reach the nearest one is taken, which may lead nowhere
      if (!all_lead_on_ && leg_to(from, s) > limits_.reach - grid_.cell / 5) continue;
      if (++steps_ > steps_end_) return nullptr;
      if (boundary.keeps(from, s.place, asked)) return &s;
    }
    return nullptr;
  }
  static double leg_to(const Box& from, const Start& s) {
    return apart(s.place, middle(from)) + radius(from);
  }
  // To where a way ends, which is no site: no way that is taken is longer.
  double straight(const Boundary& boundary, const Box& from, const std::vector<Start>& starts) {
    // such a leg keeps what the robot has, even where that is more than ways over cells keep
    if (boundary.asked_from(from, limits_.route, 0) >= limits_.route) return 1e300;
    const double asked = boundary.asked_from(from, limits_.route, straight_forgiven_m);
    for (const Start& s : starts) {
      const bool is_end = s.rest == 0 && s.clearance >= limits_.back - snap_m;
      if (!limits_.as_clear_as_here || !s.tried || !is_end) continue;
      ++steps_;
      if (boundary.keeps(from, s.place, asked)) return leg_to(from, s);
    }
    return 1e300;
  }
  // Of all cells no farther off that may be clear enough.
  [[nodiscard]] double rest_within(const Box& from, double leg, double least) const {
    // farther off it counts as the longest of all
    if (leg > 4 * limits_.reach) return *std::ranges::max_element(limits_.rest);
    const double off = leg + radius(from);
    const auto cell = [&](double at, double origin, int last) {
      return static_cast<int>(
          std::clamp(std::floor((at - origin) / grid_.cell), 0.0, double(last)));
    };
    const Place m = middle(from);
    double most = 0;
    for (int r = cell(m.y - off, grid_.y, rows_ - 1); r <= cell(m.y + off, grid_.y, rows_ - 1);
         ++r) {
      for (int c = cell(m.x - off, grid_.x, columns_ - 1);
           c <= cell(m.x + off, grid_.x, columns_ - 1); ++c) {
        if (apart(middle(box(c, r)), m) > off || clearance(c, r) < least) continue;
        most = std::max(most, limits_.rest[index(c, r)]);
      }
    }
    return most;
  }
  // The cells that may be tried from somewhere in this one, ring by ring.
  [[nodiscard]] std::vector<Start> starts_of(int column, int row, std::size_t enough) const {
    const double least =
        limits_.as_clear_as_here ? std::max(0.0, clearance(column, row)) : limits_.route;
    const double unsure_m = std::max(grid_.less, slack_m);
    std::vector<Start> found;
    int tested = 0;
    for (int off = 0; off <= std::max(columns_, rows_) && found.size() < enough; ++off) {
      std::vector<Start> of_ring;
      for (int r = std::max(0, row - off); r <= std::min(rows_ - 1, row + off); ++r) {
        const bool side = std::abs(r - row) == off;
        for (int c = column - off; c <= column + off; c += side || off == 0 ? 1 : 2 * off) {
          if (c < 0 || c >= columns_ || clearance(c, r) < least - unsure_m) continue;
          ++tested;
          if (limits_.rest[index(c, r)] < 0) continue;
          if (limits_.middles_within &&
              apart(middle(box(c, r)), middle(box(column, row))) > *limits_.middles_within) {
            continue;
          }
          of_ring.push_back(
              {middle(box(c, r)), clearance(c, r), limits_.rest[index(c, r)], off <= rings_surely});
        }
      }
      if (tested > tests_max) break;
      found.insert(found.end(), of_ring.begin(), of_ring.end());
    }
    return found;
  }

  const std::vector<Segment>& zone_;
  const Grid& grid_;
  const JoiningLimits& limits_;
  const int columns_, rows_;
  const bool all_lead_on_;
  std::optional<Box> without_;  // of the cell: from there no way begins
  std::int64_t steps_ = 0, steps_end_ = 0;
};

}  // namespace

Joining joining(const std::vector<Segment>& zone, const Grid& grid, const JoiningLimits& limits) {
  return Joins(zone, grid, limits).run();
}

}  // namespace rtac::recheck
