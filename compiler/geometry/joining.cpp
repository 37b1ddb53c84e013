#include "compiler/geometry/joining.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "compiler/geometry/connectors.h"
#include "compiler/geometry/kept.h"

namespace rtac::geometry {
namespace {

// Of the cells that it may join it tries so many, ring by ring (max_cell_tests).
constexpr int tests_max = 2000;
// Mostly one of the nearest ones does, and almost always one of some.
constexpr std::size_t nearest_ones = 12, some = 64;
// A cell is cut into four, its quarters again, at most so often.
constexpr int halvings_max = 7;
// Of cells in so many rings all legs are looked at that may lead straight to the end (2,000 cells).
constexpr std::int32_t rings_surely = 21;
// Of the clearance such a leg loses so much at most (loss_m), and others (connector_loss_m), with
// some to spare.
constexpr double straight_loss_mm = 1, join_loss_mm = 6.5;
// Beyond so many reaches what a leg leads to is not looked at: the most of all counts.
constexpr double far_reaches = 3;
// The recheck finds clearances of cells to so much, and lengths.
constexpr std::int32_t spare_mm = 5;
// Of edges and legs: of large zones with many narrow parts not all are looked at, nor are all legs
// of one cell. What has not been looked at is apart.
constexpr std::int64_t looks_max = 40'000'000, of_cell_max = 400'000;

// A cell that a way may begin at, from where there is no more clearance than it has.
struct Start {
  Landing at;
  std::int32_t clearance_mm;
  bool tried;  // a leg straight to it is looked at, if that is where the way ends
};

class Joining {
 public:
  Joining(const std::vector<EdgeRow>& edges, const CellGrid& cells, const JoinQuery& query)
      : cells_(cells),
        query_(query),
        connectors_(edges, query.route_mm, query.body_mm, join_loss_mm),
        around_(edges, std::max(query.route_mm, query.return_mm + 2 * spare_mm), query.body_mm),
        rest_most_(query.rest_mm.empty() ? 0 : *std::ranges::max_element(query.rest_mm)),
        all_lead_on_(!std::ranges::count(query.rest_mm, no_way_mm)) {}

  Joins run() {
    Joins found;
    found.apart.resize(cells_.clearance_mm_lo.size(), false);
    found.unseen.resize(cells_.clearance_mm_lo.size(), false);
    found.way_mm.resize(cells_.clearance_mm_lo.size(), 0);
    for (std::int32_t row = 0; row < cells_.rows; ++row) {
      for (std::int32_t column = 0; column < cells_.columns; ++column) {
        if (clearance_at(column, row) >= enough_mm()) continue;  // it is one itself, or needs none
        const double way = longest_from(column, row);
        found.apart[index(column, row)] = way < 0;
        found.unseen[index(column, row)] = way < 0 && looks_ > looks_end_;
        if (way <= 0) continue;
        found.way_mm[index(column, row)] = static_cast<std::int64_t>(std::ceil(way)) + spare_mm;
      }
    }
    const auto longest = std::ranges::max_element(found.way_mm);
    found.longest_mm =
        std::max<std::int64_t>(spare_mm, longest == found.way_mm.end() ? 0 : *longest);
    return found;
  }

 private:
  [[nodiscard]] std::size_t index(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_.columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::int32_t clearance_at(std::int32_t column, std::int32_t row) const {
    return cells_.clearance_mm_lo[index(column, row)];
  }
  [[nodiscard]] double west_of(std::int32_t column) const {
    return cells_.origin.x_mm + double(column) * cells_.cell_mm;
  }
  [[nodiscard]] double south_of(std::int32_t row) const {
    return cells_.origin.y_mm + double(row) * cells_.cell_mm;
  }

  // What a way asks of its cells at most: from where there is more, it needs none.
  [[nodiscard]] std::int32_t enough_mm() const {
    return query_.as_clear_as_here ? std::min(query_.route_mm, query_.return_mm) : query_.route_mm;
  }

  // The longest way from a place of the cell; negative: from some there is none. Of cells in reach
  // it takes the one with the shortest way, and beyond the nearest one.
  double longest_from(std::int32_t column, std::int32_t row) {
    const double size = cells_.cell_mm, west = west_of(column), south = south_of(row);
    const Connectors::Spot whole = around_.look_around(west, south, size, 0);
    looks_ += around_.looked_at();
    if (around_.holds_nobody(whole)) return 0;
    looks_end_ = std::min(looks_max, looks_ + of_cell_max);
    if (looks_ > looks_end_) return -1;
    without_.reset();
    for (const std::size_t enough : {nearest_ones, some, std::size_t{tests_max}}) {
      const std::vector<Start> starts = starts_of(column, row, enough);
      double reach = 0;
      for (const Start& s : starts) {
        reach =
            std::max(reach, std::hypot(s.at.x_mm - west - size / 2, s.at.y_mm - south - size / 2));
      }
      (void)connectors_.look_around(west, south, size, reach);
      looks_ += connectors_.looked_at();
      const auto spot = around_.look_around(west, south, size, 0);
      // from where none of the nearer ones did, mostly no other does
      if (without_ && first_of(*without_, starts) == nullptr) continue;
      const double way = longest_in(spot, starts, halvings_max);
      if (way >= 0) return way;
      if (starts.size() < enough) return -1;  // there are no others
    }
    return -1;
  }
  // That is clear enough, and that a leg leads to from all of the spot; null: there is none.
  const Start* first_of(const Connectors::Spot& spot, const std::vector<Start>& starts) {
    const double here = spot.gap_mm + spot.radius_mm(), enough = enough_mm();
    const double asked = query_.as_clear_as_here ? std::min(here, enough) : enough;
    for (const Start& s : starts) {
      if (s.clearance_mm < asked) continue;
      // beyond what it reaches it takes the nearest one alone, which may lead nowhere
      if (!all_lead_on_ && leg_to(spot, s) > query_.reach_mm) continue;
      looks_ += 4;
      if (connectors_.is_sound(spot, s.at)) return &s;
    }
    return nullptr;
  }
  static double leg_to(const Connectors::Spot& spot, const Start& s) {
    return std::hypot(s.at.x_mm - spot.x_mm, s.at.y_mm - spot.y_mm) + spot.radius_mm();
  }
  // Who needs no site takes a leg straight to the end of a way, if no other way is shorter.
  double straight_to_the_end(const Connectors::Spot& spot, const std::vector<Start>& starts) {
    const double none = std::numeric_limits<double>::infinity();
    // such a leg keeps what the robot has, even where that is more than ways over cells keep
    if (spot.gap_mm + spot.radius_mm() > query_.route_mm) return none;
    const double stricter = spot.radius_mm() + join_loss_mm - straight_loss_mm;
    for (const Start& s : starts) {
      const bool is_end = s.at.rest_mm == 0 && s.clearance_mm >= query_.return_mm;
      if (!query_.as_clear_as_here || !s.tried || !is_end) continue;
      looks_ += 4;
      if (connectors_.is_sound(spot, s.at, stricter)) return leg_to(spot, s);
    }
    return none;
  }
  // Of all cells no farther off that are clear enough for the least clear place.
  [[nodiscard]] double rest_within(const Connectors::Spot& spot, double leg) const {
    if (leg > far_reaches * query_.reach_mm) return double(rest_most_);
    const double here = spot.gap_mm - spot.radius_mm(), route = query_.route_mm;
    const double least = (query_.as_clear_as_here ? std::min(here, route) : route) - spare_mm;
    const double off = leg + spot.radius_mm() + spare_mm, half = cells_.cell_mm / 2.0;
    const auto first = [&](double at, double origin) {
      return static_cast<std::int32_t>(
          std::max(0.0, std::floor((at - off - origin) / cells_.cell_mm)));
    };
    const auto end = [&](double at, double origin, std::int32_t count) {
      return static_cast<std::int32_t>(
          std::min<double>(count, std::ceil((at + off - origin) / cells_.cell_mm)));
    };
    const std::int32_t rows_end = end(spot.y_mm, cells_.origin.y_mm, cells_.rows);
    const std::int32_t columns_end = end(spot.x_mm, cells_.origin.x_mm, cells_.columns);
    double most = 0;
    for (std::int32_t r = first(spot.y_mm, cells_.origin.y_mm); r < rows_end; ++r) {
      const double y = south_of(r) + half - spot.y_mm;
      for (std::int32_t c = first(spot.x_mm, cells_.origin.x_mm); c < columns_end; ++c) {
        const double x = west_of(c) + half - spot.x_mm;
        if (std::hypot(x, y) > off || clearance_at(c, r) < least) continue;
        most = std::max(most, double(query_.rest_mm[index(c, r)]));
      }
    }
    return most;
  }
  double longest_in(const Connectors::Spot& spot, const std::vector<Start>& starts, int halvings) {
    if (around_.holds_nobody(spot)) return 0;
    const bool given_back = spot.gap_mm - spot.radius_mm() >= query_.return_mm;
    if (query_.as_clear_as_here && given_back) return 0;
    if (looks_ > looks_end_) return -1;
    if (const Start* const s = first_of(spot, starts)) {
      const double leg = leg_to(spot, *s);
      // of all in reach the best one is taken
      if (leg <= query_.reach_mm) return leg + s->at.rest_mm;
      return std::min(leg + rest_within(spot, leg), straight_to_the_end(spot, starts));
    }
    if (halvings == 0) {
      without_ = spot;
      return -1;
    }
    double longest = 0;
    for (const Connectors::Spot& part : around_.quarters(spot)) {
      const double of_part = longest_in(part, starts, halvings - 1);
      if (of_part < 0) return -1;
      longest = std::max(longest, of_part);
    }
    return longest;
  }

  // The cells that a way from somewhere in this one may begin at, ring by ring as they are tried:
  // so many, and those of their ring.
  [[nodiscard]] std::vector<Start> starts_of(std::int32_t column, std::int32_t row,
                                             std::size_t enough) const {
    const std::int32_t asked =
        query_.as_clear_as_here ? std::max(clearance_at(column, row), 0) : query_.route_mm;
    std::vector<Start> found;
    int tested = 0;
    const std::int32_t last = std::max(cells_.columns, cells_.rows);
    for (std::int32_t ring = 0; ring <= last && found.size() < enough; ++ring) {
      std::vector<Start> of_ring;
      for (std::int32_t r = row - ring; r <= row + ring; ++r) {
        if (r < 0 || r >= cells_.rows) continue;
        const bool side = std::abs(r - row) == ring;
        for (std::int32_t c = column - ring; c <= column + ring;
             c += side || ring == 0 ? 1 : 2 * ring) {
          if (c < 0 || c >= cells_.columns) continue;
          const std::int32_t clearance = clearance_at(c, r);
          if (clearance < asked) continue;
          ++tested;
          const double half = cells_.cell_mm / 2.0;
          const std::int64_t rest = query_.rest_mm[index(c, r)];
          if (rest == no_way_mm) continue;
          of_ring.push_back({{west_of(c) + half, south_of(r) + half, double(rest)},
                             clearance,
                             ring <= rings_surely});
        }
      }
      if (tested > tests_max) break;  // of this ring not all of them
      found.insert(found.end(), of_ring.begin(), of_ring.end());
    }
    return found;
  }

  const CellGrid& cells_;
  const JoinQuery query_;
  Connectors connectors_;  // of legs
  Connectors around_;      // of places
  const std::int64_t rest_most_;
  const bool all_lead_on_;
  std::optional<Connectors::Spot> without_;  // of the cell: from there no way begins
  std::int64_t looks_ = 0, looks_end_ = 0;
};

}  // namespace

Joins joins(const std::vector<EdgeRow>& edges, const CellGrid& cells, const JoinQuery& query) {
  thread_local Kept<std::pair<Drawn, JoinQuery>, Joins> kept;
  return kept.find({Drawn(edges, cells), query},
                   [&] { return Joining(edges, cells, query).run(); });
}

}  // namespace rtac::geometry
