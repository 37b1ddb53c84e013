#include "compiler/geometry/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "compiler/geometry/connectors.h"
#include "compiler/geometry/kept.h"
#include "compiler/geometry/starts.h"

namespace rtac::geometry {
namespace {

// A cell is cut into four, its quarters again, at least so often, and until they are as wide.
constexpr int halvings_least = 8;
constexpr double part_mm = 1.6;
// Before it is cut so often, ways are not followed closely: most turn out to be sound.
constexpr int whole_levels = 3;
// What may be lost of the clearance in the fence: less than the 10 mm by which a hold strays, and
// more than a way may lose of that in the zone, for the grids.
constexpr double forgiven_mm = 9.5, beyond_loss_mm = 1.8, rounding_mm = 0.1;
// What the search loses where its ways over cells begin (connector_loss_m).
constexpr double over_cells_loss_mm = 8;
// By so much the clearance that is looked for first may be less than it is told, of two roundings.
constexpr std::int32_t aim_rounds_mm = 2;
// Of where bodies may be: twice that of offsets, and of the grid, so that who rounds other things
// finds the same.
constexpr std::int32_t starts_off_mm = 9;
// It tries so many cells of the zone at most, ring by ring (max_cell_tests).
constexpr int tests_max = 2000;
// And so all of those in so many rings around the cell that it begins in, with some to spare.
constexpr int rings_surely = 20, rings_spare = 2;
// Of a leg so many places are looked at that may be too far from the zone.
constexpr int samples = 24;
constexpr std::int64_t looks_max = 3'200'000'000;

struct Vec {
  double x = 0, y = 0;
};
struct Box {
  double left, low, right, top;
};
struct Cell {
  Vec middle;
  std::int32_t clearance_mm;
  std::int32_t ring;     // around the one that the search begins at
  bool settled = false;  // ways there are sound, or not taken
  double off = 0.5;      // the share of the way there after which it is farthest from the zone
};
Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y};
}
double cross(Vec a, Vec b) {
  return a.x * b.y - a.y * b.x;
}
double distance(Vec a, Vec b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}
Vec nearest_on(const EdgeRow& e, Vec p) {
  const Vec a{double(e.a.x_mm), double(e.a.y_mm)};
  const Vec d{e.b.x_mm - a.x, e.b.y_mm - a.y};
  const double along = (p.x - a.x) * d.x + (p.y - a.y) * d.y;
  const double t = std::clamp(along / (d.x * d.x + d.y * d.y), 0.0, 1.0);
  return {a.x + t * d.x, a.y + t * d.y};
}

class Entering {
 public:
  Entering(const Table& zone, const Table& fence, const EntryQuery& query)
      : zone_(zone),
        fence_(fence.cells),
        query_(query),
        starts_(query.starts ? std::optional<Starts>(Starts(*query.starts, starts_off_mm))
                             : std::nullopt),
        forgiven_(std::max(forgiven_mm, query.loss_mm + beyond_loss_mm)),
        connectors_(fence.edges, query.clearance_mm, query.body_mm, forgiven_),
        sight_(zone.edges, query.least_mm, 0, query.loss_mm - rounding_mm) {
    for (const EdgeRow& e : zone.edges) {
      const auto [left, right] = std::minmax({double(e.a.x_mm), double(e.b.x_mm)});
      const auto [low, top] = std::minmax({double(e.a.y_mm), double(e.b.y_mm)});
      boxes_.push_back({left, low, right, top});
    }
    look_at_all();
    if (query.straight_mm.front() > 0) corners_ = corners_inwards();
    if (query.depth_mm) {
      depth_ = *query.depth_mm;
      return;
    }
    for (const EdgeRow& e : fence.edges) depth_ = std::min(depth_, to_zone(e));
  }

  [[nodiscard]] std::int64_t looked_at() const { return looks_; }

  Entry run() {
    if (starts_) {
      const auto cells = starts_->cells();
      if (!cells) return {Entry::How::too_large, {}};
      fence_ = *cells;
    }
    const double size = fence_.cell_mm;
    // that is not the one that rings are counted from: it may be anywhere in a cell of the fence
    rings_surely_ = rings_surely - rings_spare - fence_.cell_mm / (2 * zone_.cells.cell_mm);
    halvings_max_ =
        std::max(halvings_least, static_cast<int>(std::ceil(std::log2(size / part_mm))));
    for (std::int32_t row = 0; row < fence_.rows; ++row) {
      for (std::int32_t column = 0; column < fence_.columns; ++column) {
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(fence_.columns) +
                        static_cast<std::size_t>(column);
        if (fence_.clearance_mm_lo[at] < 0) continue;
        const double x = fence_.origin.x_mm + column * size, y = fence_.origin.y_mm + row * size;
        const Vec middle{x + size / 2, y + size / 2};
        look_at_all();
        if (starts_ ? !starts_->are_near(middle.x, middle.y, size / std::sqrt(2.0))
                    : is_inside(middle, size / std::sqrt(2.0) + query_.least_mm)) {
          continue;
        }
        const std::vector<Cell> cells = cells_near(middle);
        double reach = nearest_of_zone(middle) + size + query_.straight_mm.front();
        for (const Cell& c : cells) reach = std::max(reach, distance(c.middle, middle));
        (void)sight_.look_around(x, y, size, reach);
        const bool stays =
            stays_within(connectors_.look_around(x, y, size, reach), cells, halvings_max_);
        if (looks_ > looks_max) return {Entry::How::too_large, {}};
        if (stays) continue;
        return {Entry::How::beyond,
                {static_cast<std::int32_t>(middle.x), static_cast<std::int32_t>(middle.y)}};
      }
    }
    return {};
  }

 private:
  [[nodiscard]] bool contains(Vec p) const {
    bool inside = false;
    for (const EdgeRow& e : zone_.edges) {
      if ((e.a.y_mm > p.y) == (e.b.y_mm > p.y)) continue;
      const double t = (p.y - e.a.y_mm) / (e.b.y_mm - e.a.y_mm);
      if (p.x < e.a.x_mm + t * (e.b.x_mm - e.a.x_mm)) inside = !inside;
    }
    return inside;
  }
  // How far its boundary is.
  [[nodiscard]] double nearest_of_zone(Vec p) {
    looks_ += static_cast<std::int64_t>(near_.size());
    double square = std::numeric_limits<double>::infinity();
    for (const std::size_t i : near_) {
      const Box& b = boxes_[i];
      const double x = std::max({b.left - p.x, p.x - b.right, 0.0});
      const double y = std::max({b.low - p.y, p.y - b.top, 0.0});
      if (x * x + y * y >= square) continue;
      const Vec q = nearest_on(zone_.edges[i], p), d = q - p;
      if (d.x * d.x + d.y * d.y >= square) continue;
      square = d.x * d.x + d.y * d.y;
    }
    return std::sqrt(square);
  }
  // All places so near to it lie in the zone.
  [[nodiscard]] bool is_inside(Vec middle, double radius) {
    return nearest_of_zone(middle) > radius && contains(middle);
  }

  // The cells of the zone that may be tried from near a place.
  std::vector<Cell> cells_near(Vec p) {
    const CellGrid& grid = zone_.cells;
    const auto at = [](double x, double origin, double size, std::int32_t count) {
      return static_cast<std::int32_t>(
          std::clamp<double>(std::floor((x - origin) / size), 0, count - 1));
    };
    const std::int32_t column = at(p.x, grid.origin.x_mm, grid.cell_mm, grid.columns);
    const std::int32_t row = at(p.y, grid.origin.y_mm, grid.cell_mm, grid.rows);
    std::vector<Cell> found;
    int tested = 0;
    // the place may lie one cell beside this one, or a cell of the fence, which is wider
    const std::int32_t more = 2 + fence_.cell_mm / grid.cell_mm;
    std::int32_t last = std::max(grid.columns, grid.rows);
    for (std::int32_t ring = 0; ring <= last; ++ring) {
      for (std::int32_t r = row - ring; r <= row + ring; ++r) {
        if (r < 0 || r >= grid.rows) continue;
        const bool side = std::abs(r - row) == ring;
        for (std::int32_t c = column - ring; c <= column + ring;
             c += side || ring == 0 ? 1 : 2 * ring) {
          if (c < 0 || c >= grid.columns) continue;
          const std::int32_t clearance =
              grid.clearance_mm_lo[static_cast<std::size_t>(r) *
                                       static_cast<std::size_t>(grid.columns) +
                                   static_cast<std::size_t>(c)];
          if (clearance >= query_.tested_mm) ++tested;
          if (clearance < query_.least_mm) continue;
          found.push_back({{grid.origin.x_mm + (c + 0.5) * grid.cell_mm,
                            grid.origin.y_mm + (r + 0.5) * grid.cell_mm},
                           clearance,
                           ring});
        }
      }
      if (tested >= tests_max) last = std::min(last, ring + more);
    }
    return found;
  }

  bool stays_within(const Connectors::Spot& spot, const std::vector<Cell>& cells, int halvings) {
    const Vec middle{spot.x_mm, spot.y_mm};
    const double radius = spot.radius_mm();
    if (connectors_.holds_nobody(spot)) return true;
    if (starts_ && !starts_->are_near(middle.x, middle.y, radius)) return true;
    const double nearest = nearest_of_zone(middle), off = contains(middle) ? -nearest : nearest;
    if (keeps_what_it_has(spot, -off - radius)) return true;
    if (looks_ > looks_max) return false;
    // its middle does: so will smaller parts, whatever ways there are; from outside where they need
    // not be too small
    const bool small = radius < forgiven_ / 4;
    const bool alike = -off > radius || query_.loss_mm < forgiven_ / 4;
    if (alike && !small && keeps_what_it_has({spot.x_mm, spot.y_mm, 0, spot.gap_mm}, -off)) {
      return in_parts(spot, cells, halvings);
    }
    // a way from outside goes on in the zone
    const bool deep = depth_ + forgiven_ >= asked_from(spot);
    if (starts_ && !deep) return in_parts(spot, cells, halvings);
    const double farthest = farthest_taken(spot, cells, off);
    const bool first = near_.size() == boxes_.size() && std::isfinite(farthest);
    if (first) look_near(spot, off, farthest);
    const bool stays = ways_stay_within(spot, cells, halvings, off, farthest);
    if (first) look_at_all();
    return stays;
  }
  bool ways_stay_within(const Connectors::Spot& spot, const std::vector<Cell>& cells, int halvings,
                        double off, double farthest) {
    const Vec middle{spot.x_mm, spot.y_mm};
    const double radius = spot.radius_mm();
    const bool closely = halvings <= halvings_max_ - whole_levels;
    const double most = off + 2 * radius + query_.loss_mm + rounding_mm;
    if (goes_straight(spot, off)) {
      return nearest_are_sound(spot, off) || in_parts(spot, cells, halvings);
    }
    // one as deep as it looks for first is seen: it asks for no less, where it does not fit yet
    const bool outside = !starts_ || radius - off < query_.least_mm;
    const bool deep = outside && is_led_straight() && std::isfinite(farthest);
    const std::int32_t least_mm = deep ? query_.alone->aim_mm - aim_rounds_mm : query_.least_mm;
    std::vector<Cell> taken;
    // Across the boundary of the zone no cell is known to be seen: once one way is not sound, those
    // far off first, smaller parts tell, from which fewer are taken.
    const bool parts_tell = query_.alone && std::abs(off) <= radius && !std::isfinite(farthest);
    bool all = true;
    for (auto each = cells.rbegin(); each != cells.rend(); ++each) {
      Cell c = *each;
      if (distance(c.middle, middle) - radius > farthest || c.clearance_mm < least_mm) continue;
      if (!c.settled && (all || !parts_tell)) {
        looks_ += 8;
        c.settled = connectors_.is_sound(spot, {c.middle.x, c.middle.y, 0}) ||
                    leads_off(spot, c, most, closely);
      }
      all = all && c.settled;
      if (query_.alone || !c.settled) taken.push_back(c);
    }
    std::ranges::reverse(taken);
    if (all && nearest_are_sound(spot, off)) return true;
    return in_parts(spot, taken, halvings);
  }
  // A retreat of a robot that is alone, which takes the leg straight away from the boundary, or in
  // through it, where that leads as deep as it looks for first.
  [[nodiscard]] bool is_led_straight() const {
    return query_.alone && query_.alone->reach_mm == 0 && query_.straight_mm.front() > 0;
  }
  // And so it does from everywhere in the spot: off an edge that is the nearest one, at a right
  // angle, to where nothing else of the boundary is as near.
  [[nodiscard]] bool goes_straight(const Connectors::Spot& spot, double off) {
    const double radius = spot.radius_mm(), wanted = query_.straight_mm.front();
    if (!is_led_straight() || std::abs(off) <= radius) return false;
    const Vec p{spot.x_mm, spot.y_mm};
    looks_ += static_cast<std::int64_t>(zone_.edges.size());
    return std::ranges::all_of(zone_.edges, [&](const EdgeRow& e) {
      if (distance(nearest_on(e, p), p) > std::abs(off) + 2 * radius) return true;
      const Vec a{double(e.a.x_mm), double(e.a.y_mm)}, b{double(e.b.x_mm), double(e.b.y_mm)};
      const double length = distance(a, b);
      const Vec along{(b.x - a.x) / length, (b.y - a.y) / length};
      const double at = (p.x - a.x) * along.x + (p.y - a.y) * along.y;
      if (at <= radius + 1 || at >= length - radius - 1) return false;
      const Vec end{a.x + at * along.x - wanted * along.y, a.y + at * along.y + wanted * along.x};
      return contains(end) && std::ranges::all_of(zone_.edges, [&](const EdgeRow& other) {
               return &other == &e || distance(nearest_on(other, end), end) > wanted + radius + 1;
             });
    });
  }
  // The edges that may be the nearest ones of places on ways from the spot, as long as those may
  // be.
  void look_near(const Connectors::Spot& spot, double off, double farthest) {
    const double way = std::max(farthest, std::abs(off) + query_.straight_mm.front());
    near_.clear();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Vec p{spot.x_mm, spot.y_mm};
      if (distance(nearest_on(zone_.edges[i], p), p) <=
          2 * (way + 2 * spot.side_mm) + std::abs(off)) {
        near_.push_back(i);
      }
    }
  }
  void look_at_all() {
    near_.resize(boxes_.size());
    std::iota(near_.begin(), near_.end(), std::size_t{0});
  }
  bool in_parts(const Connectors::Spot& spot, const std::vector<Cell>& cells, int halvings) {
    if (halvings == 0) return false;
    const auto parts = connectors_.quarters(spot);
    return std::all_of(parts.begin(), parts.end(), [&](const Connectors::Spot& part) {
      return stays_within(part, cells, halvings - 1);
    });
  }
  // Ways that begin in the zone, so far from its boundary, lose `loss_mm` at most of that, or of
  // what a body needs, and all of it is as much farther from the boundary of the fence as the two
  // are apart. Where a body fits in the zone that is enough for what a fence with an end asks
  // (analysis: keeps_off.h); who is nearer is led straight, and that clearance is all it keeps.
  // From outside, less than 0, no way leads farther off than that and as much.
  [[nodiscard]] bool keeps_what_it_has(const Connectors::Spot& spot, double nearest) const {
    if (!starts_ && nearest >= query_.least_mm) return true;
    double kept = std::min<double>(nearest, query_.kept_mm) - query_.loss_mm;
    // where a body fits it may go over cells as well, whatever a leg straight to a place loses
    const bool fits = nearest + 2 * spot.radius_mm() >= query_.least_mm;
    if (fits) {
      const double has = std::max<double>(nearest, query_.least_mm);
      kept = std::min(kept, std::min<double>(has, query_.kept_mm) - over_cells_loss_mm);
    }
    return depth_ + kept + forgiven_ >= asked_from(spot);
  }
  [[nodiscard]] double asked_from(const Connectors::Spot& spot) const {
    return std::min<double>(query_.clearance_mm, spot.gap_mm + spot.radius_mm());
  }
  // How far the zone is from an edge of the fence that it lies in.
  double to_zone(const EdgeRow& of) {
    const Vec a{double(of.a.x_mm), double(of.a.y_mm)}, b{double(of.b.x_mm), double(of.b.y_mm)};
    double least = std::min(nearest_of_zone(a), nearest_of_zone(b));
    for (const EdgeRow& e : zone_.edges) {
      const Vec at{double(e.a.x_mm), double(e.a.y_mm)};
      least = std::min(least, distance(nearest_on(of, at), at));
    }
    return least;
  }
  // The way from anywhere in the spot to the cell leads farther from the zone than `most`; in the
  // zone that is less than 0.
  bool leads_off(const Connectors::Spot& spot, Cell& cell, double most, bool closely) {
    double most_off = -std::numeric_limits<double>::infinity();
    const auto look = [&](double t) {
      const Vec at{spot.x_mm + t * (cell.middle.x - spot.x_mm),
                   spot.y_mm + t * (cell.middle.y - spot.y_mm)};
      double way = nearest_of_zone(at);
      if (way > most_off && contains(at)) way = -way;
      if (way > most_off) cell.off = t, most_off = way;
      return most_off > most;
    };
    if (look(cell.off)) return true;
    for (int i = 1; i < samples; i += closely ? 1 : 6) {
      if (look(double(i) / samples)) return true;
    }
    for (double step = 0.5 / samples; closely && step > 0.005 / samples; step /= 2) {
      const double from = cell.off;
      if (look(std::max(from - step, 0.0)) || look(std::min(from + step, 1.0))) return true;
    }
    return false;
  }
  // How far off a cell may be that it takes: of a robot that is alone, no farther than any one that
  // it surely sees. Those that it takes from a part of the spot are among those of the whole.
  double farthest_taken(const Connectors::Spot& spot, const std::vector<Cell>& cells, double off) {
    const Vec middle{spot.x_mm, spot.y_mm};
    double nearest = std::numeric_limits<double>::infinity();
    if (!query_.alone) return nearest;
    for (const Cell& c : cells) {
      const double way = distance(c.middle, middle) + spot.radius_mm();
      if (c.clearance_mm < query_.alone->aim_mm || c.ring > rings_surely_ || way >= nearest)
        continue;
      if (is_seen(spot, off, c.middle)) nearest = way;
    }
    return std::max<double>(nearest, query_.alone->reach_mm);
  }
  // From each place of the zone that may be the nearest one a straight way in the zone leads there:
  // then a way from the spot is nowhere farther from the zone than it begins, since it is as far
  // from that other way at most, of each place the share that is left. In the zone that would be a
  // loss of what it has, twice: not of so little.
  bool is_seen(const Connectors::Spot& spot, double off, Vec to) {
    const Vec middle{spot.x_mm, spot.y_mm};
    const double radius = spot.radius_mm(), half = spot.side_mm / 2;
    if (-off > radius) {
      const double gap = std::min<double>(-off, query_.least_mm);
      return sight_.is_sound({spot.x_mm, spot.y_mm, spot.side_mm, gap}, {to.x, to.y, 0});
    }
    if (off < radius && 2 * (radius - off) > query_.loss_mm) return false;
    off = std::max(off, 0.0);
    looks_ += static_cast<std::int64_t>(zone_.edges.size());
    for (const EdgeRow& e : zone_.edges) {
      if (distance(nearest_on(e, middle), middle) > off + 2 * radius) continue;
      std::array<Vec, 2> ends{nearest_on(e, middle), nearest_on(e, middle)};
      double first = std::numeric_limits<double>::infinity(), last = -first;
      for (const double x : {-half, half}) {
        for (const double y : {-half, half}) {
          const Vec b = nearest_on(e, {middle.x + x, middle.y + y});
          const double along =
              (b.x - e.a.x_mm) * (e.b.x_mm - e.a.x_mm) + (b.y - e.a.y_mm) * (e.b.y_mm - e.a.y_mm);
          if (along < first) first = along, ends[0] = b;
          if (along > last) last = along, ends[1] = b;
        }
      }
      if (!sees_all(ends, to)) return false;
    }
    return true;
  }
  // The triangle lies in the zone, but for its first millimetre.
  bool sees_all(std::array<Vec, 2> from, Vec to) {
    for (Vec& b : from) {
      const double way = distance(b, to);
      if (way <= 1) return false;
      b = {b.x + (to.x - b.x) / way, b.y + (to.y - b.y) / way};
      if (!contains(b)) return false;
    }
    looks_ += 2 * static_cast<std::int64_t>(zone_.edges.size());
    return std::none_of(zone_.edges.begin(), zone_.edges.end(), [&](const EdgeRow& e) {
      const Vec a{double(e.a.x_mm), double(e.a.y_mm)}, z{double(e.b.x_mm), double(e.b.y_mm)};
      const auto crosses = [&](Vec b) {
        const double a_side = cross(to - b, a - b), z_side = cross(to - b, z - b);
        const double b_side = cross(z - a, b - a), to_side = cross(z - a, to - a);
        return a_side * z_side <= 0 && b_side * to_side <= 0;
      };
      const double side = cross(from[1] - from[0], to - from[0]);
      const bool inside = side != 0 && cross(from[1] - from[0], a - from[0]) * side > 0 &&
                          cross(to - from[1], a - from[1]) * side > 0 &&
                          cross(from[0] - to, a - to) * side > 0;
      return inside || crosses(from[0]) || crosses(from[1]);
    });
  }
  // Straight through the nearest place of the boundary of the zone, or away from it, up to where
  // that is as far as is wanted, if nothing else of it is nearer there.
  bool nearest_are_sound(const Connectors::Spot& spot, double off) {
    const double radius = spot.radius_mm(), near = std::abs(off) + 2 * radius;
    const double farthest = query_.straight_mm.front();
    const bool recedes = off < radius && recedes_enough(spot, std::max(-off - radius, 0.0));
    if (recedes && -off > radius) return true;
    const Vec p{spot.x_mm, spot.y_mm};
    // What is as far from an edge beside a corner leads off at a right angle, up to the micrometre
    // that is forgiven there (find_straight), but in the zone, from a corner that points into it.
    const double aside = radius + std::sqrt(0.002 * farthest);
    for (const EdgeRow& e : zone_.edges) {
      const Vec q = nearest_on(e, p);
      if (distance(q, p) > near) continue;
      const Vec along{double(e.b.x_mm) - e.a.x_mm, double(e.b.y_mm) - e.a.y_mm};
      const double length = distance(along, {});
      const Vec left{-along.y / length, along.x / length};
      if (!is_straight_sound(spot, q, left, aside)) return false;
      if (farthest > 0 && !is_straight_sound(spot, q, Vec{} - left, aside)) return false;
    }
    if (off >= radius || recedes || farthest == 0) return true;
    return std::ranges::all_of(corners_, [&](Vec v) {
      const double way = distance(v, p);
      if (way > near) return true;
      if (way <= radius) {  // it leads anywhere
        return connectors_.is_sound(spot, {v.x, v.y, 0}, farthest + 1);
      }
      const Vec on{(p.x - v.x) / way, (p.y - v.y) / way};
      return is_straight_sound(spot, v, on, 2 * radius * farthest / (2 * way - radius));
    });
  }
  // Corners that point into the zone: from the smaller angle beside them one looks out of it.
  [[nodiscard]] std::vector<Vec> corners_inwards() const {
    std::vector<Vec> found;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<const EdgeRow*>> from;
    for (const EdgeRow& e : zone_.edges) from[{e.a.x_mm, e.a.y_mm}].push_back(&e);
    for (const EdgeRow& e : zone_.edges) {
      const auto next = from.find({e.b.x_mm, e.b.y_mm});
      const Vec v{double(e.b.x_mm), double(e.b.y_mm)};
      if (next != from.end() && next->second.size() == 1) {
        const EdgeRow& n = *next->second.front();
        const Vec a{double(e.a.x_mm), double(e.a.y_mm)}, b{double(n.b.x_mm), double(n.b.y_mm)};
        const double first = distance(a, v), second = distance(b, v);
        constexpr double step_mm = 0.01;
        if (contains({v.x + step_mm * ((b.x - v.x) / second + (a.x - v.x) / first),
                      v.y + step_mm * ((b.y - v.y) / second + (a.y - v.y) / first)})) {
          continue;
        }
      }
      found.push_back(v);
    }
    return found;
  }
  // From the spot through q, or to near there, up to each clearance that may be wanted.
  bool is_straight_sound(const Connectors::Spot& spot, Vec q, Vec on, double off) {
    for (const std::int32_t wanted : query_.straight_mm) {
      const Vec end{q.x + wanted * on.x, q.y + wanted * on.y};
      if (connectors_.is_sound(spot, {end.x, end.y, 0}, off)) return true;  // and less of it
      const bool taken = wanted == 0 || (nearest_of_zone(end) + off + 1 > wanted &&
                                         (nearest_of_zone(end) <= off || contains(end)));
      if (taken) return false;
    }
    return true;
  }
  // Who is c from the boundary of the zone is led straight away from it over w - c, to a place that
  // is w from all of it, so w + depth from that of the fence, of which nothing was nearer than A.
  // Of what is y ahead and x beside: x^2 + y^2 >= A^2 and x^2 + (w - c - y)^2 >= (w + depth)^2. So
  // x is least where both are equal, at y = (A^2 + (w - c)^2 - (w + depth)^2) / (2 (w - c)), or
  // nothing is ahead. Less than is forgiven, f, is lost if y^2 <= A^2 - (A - f)^2: for the largest
  // A also for lesser ones, as y grows with its square, and the root of that slower.
  [[nodiscard]] bool recedes_enough(const Connectors::Spot& spot, double nearest) const {
    const double wanted = query_.straight_mm.back(), most = nearest + 2 * spot.radius_mm();
    if (wanted <= most + forgiven_) return false;
    const double asked = asked_from(spot), end = wanted + depth_, way = wanted - nearest;
    const double ahead = (asked * asked + way * way - end * end) / (2 * (wanted - most));
    return end + forgiven_ >= asked &&
           (ahead <= 0 || ahead * ahead <= 2 * asked * forgiven_ - forgiven_ * forgiven_);
  }

  const Table& zone_;
  CellGrid fence_;
  const EntryQuery query_;
  const std::optional<Starts> starts_;
  double depth_ = std::numeric_limits<double>::infinity();  // of the zone in the fence
  const double forgiven_;
  Connectors connectors_;
  Connectors sight_;               // in the zone
  std::vector<Box> boxes_;         // of the edges of the zone
  std::vector<std::size_t> near_;  // of those, for the cell
  std::vector<Vec> corners_;       // of the zone, that point into it
  int halvings_max_ = halvings_least, rings_surely_ = 0;
  std::int64_t looks_ = 0;
};

// All but where bodies may be.
bool same_numbers(const EntryQuery& a, const EntryQuery& b) {
  const auto numbers = [](const EntryQuery& q) {
    return std::tuple(q.clearance_mm, q.body_mm, q.least_mm, q.tested_mm, q.kept_mm, q.loss_mm,
                      q.straight_mm, q.alone.has_value(), q.alone ? q.alone->aim_mm : 0,
                      q.alone ? q.alone->reach_mm : 0, q.depth_mm, q.starts.has_value());
  };
  return numbers(a) == numbers(b);
}

}  // namespace

Entry entry(const Table& zone, const Table& fence, const EntryQuery& query) {
  struct Question {
    Drawn zone, fence;
    EntryQuery query;
    std::vector<Ring> starts;
    bool operator==(const Question& q) const {
      return zone == q.zone && fence == q.fence && same_numbers(query, q.query) &&
             starts == q.starts;
    }
  };
  thread_local Kept<Question, Entry> kept;
  Question question{{zone.edges, zone.cells}, {fence.edges, fence.cells}, query, {}};
  if (query.starts) question.starts = query.starts->rings();
  return kept.find(std::move(question), [&] {
    Entering entering(zone, fence, query);
    Entry found = entering.run();
    looks() += entering.looked_at();
    return found;
  });
}

}  // namespace rtac::geometry
