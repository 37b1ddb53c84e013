#include "compiler/geometry/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compiler/geometry/connectors.h"

namespace rtac::geometry {
namespace {

// A cell is cut into four, its quarters again, at most so often.
constexpr int halvings_max = 8;
// Before it is cut so often, ways are not followed closely: most turn out to be sound.
constexpr int whole_levels = 3;
// What may be lost of the clearance in the fence: less than the 10 mm by which a hold strays, and
// more than a way may lose of that in the zone, for the grids.
constexpr double forgiven_mm = 8, beyond_loss_mm = 1.8, rounding_mm = 0.1;
// It tries so many cells of the zone at most, ring by ring (max_cell_tests).
constexpr int tests_max = 2000;
// And so all of those in so many rings, from wherever in a cell of the fence it begins.
constexpr int rings_surely = 18;
// Of a leg so many places are looked at that may be too far from the zone.
constexpr int samples = 24;
constexpr std::int64_t looks_max = 1'600'000'000;

struct Vec {
  double x = 0, y = 0;
};
struct Box {
  double left, low, right, top;
};
struct Cell {
  Vec middle;
  std::int32_t clearance_mm;
  std::int32_t ring;  // around the one that the search begins at
  double off = 0.5;   // the share of the way there after which it is farthest from the zone
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

struct Line {
  Vec a, b;
};
// Where bodies may be, as far as offsets and the grid tell.
class Starts {
 public:
  explicit Starts(const Region& region) {
    for (const Ring& ring : region.rings()) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        lines_.push_back(
            {{1e3 * a.x.get_d(), 1e3 * a.y.get_d()}, {1e3 * b.x.get_d(), 1e3 * b.y.get_d()}});
      }
    }
  }
  // Cells that cover them; nullopt: they have no end.
  [[nodiscard]] std::optional<CellGrid> cells() const {
    constexpr double far_mm = 1e8, most = 40'000;  // zones lie within 100 km of the origin
    Box box{far_mm, far_mm, -far_mm, -far_mm};
    for (const Line& e : lines_) {
      box = {std::min(box.left, e.a.x), std::min(box.low, e.a.y), std::max(box.right, e.a.x),
             std::max(box.top, e.a.y)};
    }
    CellGrid grid;
    if (lines_.empty()) return grid;
    const double farthest = std::max({-box.left, -box.low, box.right, box.top});
    if (farthest > far_mm) return std::nullopt;
    const double wide = box.right - box.left, high = box.top - box.low;
    while (wide * high > most * grid.cell_mm * grid.cell_mm) grid.cell_mm *= 2;
    grid.origin = {static_cast<std::int32_t>(box.left) - 2 * rounding,
                   static_cast<std::int32_t>(box.low) - 2 * rounding};
    grid.columns = static_cast<std::int32_t>((wide + 4 * rounding) / grid.cell_mm) + 1;
    grid.rows = static_cast<std::int32_t>((high + 4 * rounding) / grid.cell_mm) + 1;
    grid.clearance_mm_lo.assign(
        static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 0);
    return grid;
  }
  // Some of them may be so near.
  [[nodiscard]] bool are_near(Vec p, double within) const {
    bool inside = false;
    for (const Line& e : lines_) {
      const Vec d = e.b - e.a, off = p - e.a;
      const double t = std::clamp((off.x * d.x + off.y * d.y) / (d.x * d.x + d.y * d.y), 0.0, 1.0);
      if (distance(p, {e.a.x + t * d.x, e.a.y + t * d.y}) <= within + rounding) return true;
      if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
      if (p.x < e.a.x + (p.y - e.a.y) / d.y * d.x) inside = !inside;
    }
    return inside;
  }

 private:
  static constexpr std::int32_t rounding = 3;  // mm
  std::vector<Line> lines_;
};

class Entering {
 public:
  Entering(const Table& zone, const Table& fence, const EntryQuery& query)
      : zone_(zone),
        fence_(fence.cells),
        query_(query),
        starts_(query.starts ? std::optional<Starts>(*query.starts) : std::nullopt),
        forgiven_(std::max(forgiven_mm, query.loss_mm + beyond_loss_mm)),
        connectors_(fence.edges, query.clearance_mm, query.body_mm, forgiven_) {
    for (const EdgeRow& e : zone.edges) {
      const auto [left, right] = std::minmax({double(e.a.x_mm), double(e.b.x_mm)});
      const auto [low, top] = std::minmax({double(e.a.y_mm), double(e.b.y_mm)});
      boxes_.push_back({left, low, right, top});
    }
    if (!starts_) return;
    for (const EdgeRow& e : fence.edges) depth_ = std::min(depth_, to_zone(e));
  }

  Entry run() {
    if (starts_) {
      const auto cells = starts_->cells();
      if (!cells) return {Entry::How::too_large, {}};
      fence_ = *cells;
    }
    const double size = fence_.cell_mm;
    for (std::int32_t row = 0; row < fence_.rows; ++row) {
      for (std::int32_t column = 0; column < fence_.columns; ++column) {
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(fence_.columns) +
                        static_cast<std::size_t>(column);
        if (fence_.clearance_mm_lo[at] < 0) continue;
        const double x = fence_.origin.x_mm + column * size, y = fence_.origin.y_mm + row * size;
        const Vec middle{x + size / 2, y + size / 2};
        if (starts_ ? !starts_->are_near(middle, size / std::sqrt(2.0))
                    : is_inside(middle, size / std::sqrt(2.0))) {
          continue;
        }
        const std::vector<Cell> cells = cells_near(middle);
        double reach = 0;
        for (const Cell& c : cells) reach = std::max(reach, distance(c.middle, middle));
        const bool stays =
            stays_within(connectors_.look_around(x, y, size, reach), cells, halvings_max);
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
    looks_ += static_cast<std::int64_t>(zone_.edges.size());
    double square = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
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
    if (starts_ ? !starts_->are_near(middle, radius) || keeps_what_it_has(spot)
                : is_inside(middle, radius)) {
      return true;
    }
    if (looks_ > looks_max) return false;
    // a way from outside goes on in the zone
    const bool deep = depth_ + forgiven_ >= query_.clearance_mm;
    if (starts_ && !deep) return halvings > 0 && in_parts(spot, cells, halvings);
    const double off = contains(middle) ? 0 : nearest_of_zone(middle);
    const bool closely = halvings <= halvings_max - whole_levels;
    const double farthest = farthest_taken(spot, cells, off);
    std::vector<Cell> taken, open;
    for (Cell c : cells) {
      if (distance(c.middle, middle) - radius > farthest) continue;
      looks_ += 8;
      const double most = off + 2 * radius + query_.loss_mm + rounding_mm;
      const bool stays = connectors_.is_sound(spot, {c.middle.x, c.middle.y, 0}) ||
                         leads_off(spot, c, most, closely);
      if (query_.alone) taken.push_back(c);
      if (!stays) open.push_back(c);
    }
    if (open.empty() && nearest_are_sound(spot, off)) return true;
    return halvings > 0 && in_parts(spot, query_.alone ? taken : open, halvings);
  }
  bool in_parts(const Connectors::Spot& spot, const std::vector<Cell>& cells, int halvings) {
    const auto parts = connectors_.quarters(spot);
    return std::all_of(parts.begin(), parts.end(), [&](const Connectors::Spot& part) {
      return stays_within(part, cells, halvings - 1);
    });
  }
  // Ways that begin in the zone lose `loss_mm` at most of the clearance in it, or of what a body
  // needs, and all of it is as much farther from the boundary of the fence as the two are apart.
  bool keeps_what_it_has(const Connectors::Spot& spot) {
    const Vec middle{spot.x_mm, spot.y_mm};
    const double nearest = nearest_of_zone(middle), radius = spot.radius_mm();
    const double asked = std::min<double>(query_.clearance_mm, spot.gap_mm + radius);
    const double kept = std::min<double>(nearest - radius, query_.least_mm) - query_.loss_mm;
    return nearest > radius && contains(middle) && depth_ + kept + forgiven_ >= asked;
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
  // The way from anywhere in the spot to the cell leads farther from the zone than `most`.
  bool leads_off(const Connectors::Spot& spot, Cell& cell, double most, bool closely) {
    double most_off = 0;
    const auto look = [&](double t) {
      const Vec at{spot.x_mm + t * (cell.middle.x - spot.x_mm),
                   spot.y_mm + t * (cell.middle.y - spot.y_mm)};
      const double way = nearest_of_zone(at);
      if (way > most_off && !contains(at)) cell.off = t, most_off = way;
      return most_off > most;
    };
    if (look(cell.off)) return true;
    for (int i = 1; i < samples; i += closely ? 1 : 6) {
      if (look(double(i) / samples)) return true;
    }
    for (double step = 0.5 / samples; closely && step > 0.005 / samples; step /= 2) {
      const double from = cell.off;
      if (look(from - step) || look(from + step)) return true;
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
      if (c.clearance_mm < query_.alone->aim_mm || c.ring > rings_surely || way >= nearest)
        continue;
      if (is_seen(spot, off, c.middle)) nearest = way;
    }
    return std::max<double>(nearest, query_.alone->reach_mm);
  }
  // From each place of the zone that may be the nearest one a straight way in the zone leads there:
  // then a way from the spot is nowhere farther from the zone than it begins, since it is as far
  // from that other way at most, of each place the share that is left.
  bool is_seen(const Connectors::Spot& spot, double off, Vec to) {
    const Vec middle{spot.x_mm, spot.y_mm};
    const double radius = spot.radius_mm(), half = spot.side_mm / 2;
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
  // Straight to the nearest place of the zone: of each edge, as far off as the spot is wide.
  bool nearest_are_sound(const Connectors::Spot& spot, double off) {
    const double radius = spot.radius_mm();
    return std::all_of(zone_.edges.begin(), zone_.edges.end(), [&](const EdgeRow& e) {
      const Vec q = nearest_on(e, {spot.x_mm, spot.y_mm});
      const double way = distance(q, {spot.x_mm, spot.y_mm});
      return way > off + 2 * radius || connectors_.is_sound(spot, {q.x, q.y, 0}, radius);
    });
  }

  const Table& zone_;
  CellGrid fence_;
  const EntryQuery query_;
  const std::optional<Starts> starts_;
  double depth_ = std::numeric_limits<double>::infinity();  // of the zone in the fence
  const double forgiven_;
  Connectors connectors_;
  std::vector<Box> boxes_;  // of the edges of the zone
  std::int64_t looks_ = 0;
};

}  // namespace

Entry entry(const Table& zone, const Table& fence, const EntryQuery& query) {
  return Entering(zone, fence, query).run();
}

}  // namespace rtac::geometry
