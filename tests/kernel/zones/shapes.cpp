#include "tests/kernel/zones/shapes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace rtac::kernel_test {
namespace {

Ring reversed(const Ring& ring) {
  return {ring.rbegin(), ring.rend()};
}
Wide doubled_area(const Ring& ring) {
  Wide area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) area += cross(ring[i], ring[(i + 1) % ring.size()]);
  return area;
}
// Neighbouring edges meet in their vertex alone, others nowhere.
bool is_simple(const Ring& ring) {
  const std::vector<Edge> edges = edges_of({"", {ring}});
  const std::size_t n = edges.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool next = j == i + 1 || (i == 0 && j == n - 1);
      if (!next && meet(edges[i], edges[j])) return false;
      if (!next) continue;
      const Edge &first = j == i + 1 ? edges[i] : edges[j],
                 &then = j == i + 1 ? edges[j] : edges[i];
      if (first.a == first.b || on_edge(then.b, first) || on_edge(first.a, then)) return false;
    }
  }
  return true;
}
Place polar(double radius, double angle) {
  return {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))};
}
double turn(int i, int n) {
  return 2 * std::numbers::pi * i / n;
}
// Anything between the two as likely as twice as much.
std::int64_t scale(int least_bits, int most_bits, Random& random) {
  return (std::int64_t{1} << random.in(least_bits, most_bits)) + random.in(0, 1 << least_bits);
}

Zone tiny(Random& random) {
  for (;;) {
    Ring ring;
    for (std::int64_t n = random.in(3, 4); n > 0; --n) {
      ring.push_back({random.in(0, 5), random.in(0, 5)});
    }
    if (!is_simple(ring)) continue;
    if (doubled_area(ring) < 0) ring = reversed(ring);
    if (doubled_area(ring) > 0) return {"", {ring}};
  }
}

constexpr int board = 8;
using Board = std::array<std::array<bool, board + 2>, board + 2>;

// The unit edge that leaves (x, y) with the zone on its left, turning left first where squares
// touch: they stay rings of their own. `dx`, `dy`: where the way comes from.
bool leaves(const Board& taken, int x, int y, int dx, int dy) {
  // the square on the left and the one on the right of the edge
  const int left_x = dx > 0 ? x : (dx < 0 ? x - 1 : (dy > 0 ? x - 1 : x));
  const int left_y = dy > 0 ? y : (dy < 0 ? y - 1 : (dx > 0 ? y : y - 1));
  const int right_x = dy > 0 ? x : (dy < 0 ? x - 1 : left_x);
  const int right_y = dx > 0 ? y - 1 : (dx < 0 ? y : left_y);
  const auto at = [&](int column, int row) {
    return taken[static_cast<std::size_t>(row + 1)][static_cast<std::size_t>(column + 1)];
  };
  return at(left_x, left_y) && !at(right_x, right_y);
}
std::vector<Ring> outlines(const Board& taken) {
  std::array<std::array<std::array<bool, 4>, board + 1>, board + 1> seen{};
  constexpr std::array<int, 4> dx{1, 0, -1, 0}, dy{0, 1, 0, -1};
  const auto goes = [&](int x, int y, std::size_t k) { return leaves(taken, x, y, dx[k], dy[k]); };
  std::vector<Ring> rings;
  for (int row = 0; row <= board; ++row) {
    for (int column = 0; column <= board; ++column) {
      for (std::size_t start = 0; start < 4; ++start) {
        Ring ring;
        int x = column, y = row;
        std::size_t k = start;
        const auto is_new = [&] {
          return goes(x, y, k) && !seen[std::size_t(y)][std::size_t(x)][k];
        };
        while (is_new()) {
          seen[std::size_t(y)][std::size_t(x)][k] = true;
          ring.push_back({x, y});
          x += dx[k];
          y += dy[k];
          for (const std::size_t turned : {std::size_t{1}, std::size_t{0}, std::size_t{3}}) {
            if (goes(x, y, (k + turned) % 4)) {
              k = (k + turned) % 4;
              break;
            }
          }
        }
        if (!ring.empty()) rings.push_back(ring);
      }
    }
  }
  return rings;
}
Zone cells(Random& random) {
  Board taken{};
  for (std::size_t row = 1; row <= board; ++row) {
    for (std::size_t column = 1; column <= board; ++column) {
      taken[row][column] = random.in(0, 2) > 0;
    }
  }
  taken[1][1] = true;
  const std::int64_t size = random.one_in(2) ? 1 : scale(1, 20, random);
  Zone zone{"", outlines(taken)};
  for (Ring& ring : zone.rings) {
    for (Place& p : ring) p = {p.x * size, p.y * size};
  }
  return zone;
}

Ring star_ring(int n, double least, double most, Random& random) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = turn(1, n) * (i + 0.8 * random.unit());
    ring.push_back(polar(least + (most - least) * random.unit(), angle));
  }
  return ring;
}
Zone star(Random& random) {
  const auto size = static_cast<double>(scale(7, 27, random));
  for (;;) {
    Zone zone{"", {star_ring(static_cast<int>(random.in(5, 20)), size / 2, size, random)}};
    zone.rings.push_back(
        reversed(star_ring(static_cast<int>(random.in(5, 9)), size / 16, size / 8, random)));
    if (is_simple(zone.rings[0]) && is_simple(zone.rings[1])) return zone;
  }
}
Zone round_zone(Random& random) {
  for (;;) {
    const int n = static_cast<int>(random.in(8, 200));
    const auto radius = static_cast<double>(scale(8, 28, random));
    Ring ring;
    for (int i = 0; i < n; ++i) ring.push_back(polar(radius, turn(i, n)));
    if (is_simple(ring)) return {"", {ring}};
  }
}

Zone corridor(Random& random) {
  const std::int64_t size = scale(4, 28, random), width = random.in(1, 3);
  const Place along{random.in(1, size), random.in(-size, size)};
  Ring ring{{0, 0}, along, {along.x, along.y + width}, {0, width}};
  const bool flat = random.one_in(4), upright = !flat && random.one_in(4);
  if (flat) ring = {{0, 0}, {size, 0}, {size, width}, {0, width}};
  if (upright) ring = {{0, 0}, {width, 0}, {width, size}, {0, size}};
  return {"", {ring}};
}

// Around a square, needles at right angles to its sides: outwards on the right, inwards on the
// left.
Ring spiky_ring(Random& random) {
  const std::int64_t size = scale(8, 26, random);
  Ring ring{{0, 0}, {size, 0}};
  const int needles = static_cast<int>(random.in(1, 6));
  const std::int64_t step = size / (needles + 1);
  for (int i = 1; i <= needles; ++i) {
    const std::int64_t y = i * step, length = random.in(1, size - 1);
    ring.push_back({size, y});
    ring.push_back({size + length, y + random.in(-step / 2, step / 2)});
    ring.push_back({size, y + 1});
  }
  ring.push_back({size, size});
  ring.push_back({0, size});
  for (int i = needles; i >= 1; --i) {
    const std::int64_t y = i * step, length = random.in(1, size - 1);
    ring.push_back({0, y + 1});
    ring.push_back({length, y + random.in(0, 1)});
    ring.push_back({0, y});
  }
  return ring;
}
Zone spiky(Random& random) {
  for (;;) {
    const Ring ring = spiky_ring(random);
    if (is_simple(ring)) return {"", {ring}};
  }
}

Zone comb(Random& random) {
  const int teeth = static_cast<int>(random.in(2, 40));
  const std::int64_t width = random.one_in(2) ? random.in(1, 3) : random.in(1, 5'000);
  const std::int64_t height = scale(3, 24, random), gap = random.in(1, 3);
  Ring ring{{0, -height}, {teeth * (width + gap) - gap, -height}};
  for (int i = teeth - 1; i >= 0; --i) {
    const std::int64_t x = i * (width + gap);
    const std::int64_t top = random.in(2, height), bottom = random.in(0, 1);
    ring.push_back({x + width, top});
    ring.push_back({x, top});
    if (i > 0) {
      ring.push_back({x, bottom});
      ring.push_back({x - gap, bottom});
    }
  }
  return {"", {ring}};
}

// A corridor that winds inwards, with walls of 1 mm: its outer wall, and its inner one back.
Zone spiral(Random& random) {
  const std::int64_t width = random.one_in(2) ? random.in(1, 3) : random.in(1, 10'000);
  const std::int64_t turns = random.in(2, 8), pitch = width + 1, size = 2 * pitch * (turns + 2);
  const auto wall = [&](std::int64_t off) {
    Ring way{{0, off}};
    for (std::int64_t t = 0; t < turns; ++t) {
      const std::int64_t low = t * pitch + off, high = size - low;
      way.insert(way.end(), {{high, low}, {high, high}, {low, high}});
      way.push_back({low, (t + 1) * pitch + (t + 1 < turns ? off : width)});
    }
    return way;
  };
  Ring ring = wall(0);
  const Ring back = wall(width);
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return {"", {ring}};
}

Zone touching(Random& random) {
  const std::int64_t s = scale(0, 24, random);  // a square of 12 s
  Zone zone{"", {{{0, 0}, {12 * s, 0}, {12 * s, 12 * s}, {0, 12 * s}}}};
  const auto hole = [&](Ring ring) {
    for (Place& p : ring) p = {p.x * s, p.y * s};
    zone.rings.push_back(ring);
  };
  // Clockwise; a tip on the left side, two tips at one place, a tip on the middle of a side.
  if (random.one_in(2)) hole({{0, 6}, {2, 8}, {2, 4}});
  if (random.one_in(2)) hole({{4, 4}, {6, 6}, {6, 2}});
  if (random.one_in(2)) hole({{6, 6}, {6, 9}, {9, 9}});
  if (random.one_in(2)) hole({{6, 4}, {9, 7}, {9, 3}});
  if (random.one_in(2)) hole({{12, 12}, {11, 9}, {10, 10}});
  return zone;
}

Zone stairs(Random& random) {
  const int steps = static_cast<int>(random.in(2, 60));
  const std::int64_t s = random.one_in(2) ? 1 : random.in(1, 1'000);
  Ring ring{{0, 0}, {(steps + 1) * s, 0}};
  for (int i = 0; i < steps; ++i) {
    ring.push_back({(steps + 1 - i) * s, (i + 1) * s});
    ring.push_back({(steps - i) * s, (i + 1) * s});
  }
  ring.push_back({s, (steps + 1) * s});
  ring.push_back({0, (steps + 1) * s});
  return {"", {ring}};
}

Zone runs(Random& random) {
  const std::int64_t dx = random.in(1, 50'000), dy = random.in(1, 50'000), n = random.in(2, 30);
  Ring ring;
  for (std::int64_t i = 0; i < n; ++i) ring.push_back({i * dx, i * dy});
  for (std::int64_t i = 0; i < n; ++i) ring.push_back({n * dx - i * dy, n * dy + i * dx});
  for (std::int64_t i = n; i > 0; --i) ring.push_back({i * dx - n * dy, i * dy + n * dx});
  for (std::int64_t i = n; i > 0; --i) ring.push_back({-i * dy, i * dx});
  return {"", {ring}};
}

Zone fence(Random& random) {
  for (;;) {
    const int n = static_cast<int>(random.in(40, 250));
    Ring ring;
    double radius = 80.0 * n;  // 500 mm from vertex to vertex
    for (int i = 0; i < n; ++i) {
      radius *= 0.97 + 0.06 * random.unit();
      radius = std::min(std::max(radius, 60.0 * n), 120.0 * n);
      ring.push_back(polar(radius, turn(i, n)));
    }
    Zone zone{"", {ring, reversed(star_ring(8, 10.0 * n, 20.0 * n, random))}};
    if (is_simple(zone.rings[0]) && is_simple(zone.rings[1])) return zone;
  }
}

Zone huge(Random& random) {
  const std::int64_t m = extent_mm, s = random.in(1, 1'000);
  switch (random.in(0, 3)) {
    case 0:
      return {"", {{{-m, -m}, {m, -m}, {m, m}, {-m, m}}}};
    case 1:
      return {"", {{{-m, -m}, {m, m - s}, {m, m}}}};
    case 2:
      return {"",
              {{{-m, -m}, {m, -m}, {m, m}, {-m, m}},
               {{1 - m, 1 - m}, {-m + s, m - 1}, {m - 1, s - m}}}};
    default: {
      const Ring star = star_ring(30, 3e8, 5.3e8, random);
      return {"", {star, reversed(star_ring(5, 1e3, 1e8, random))}};
    }
  }
}

Zone local_zone(Family family, Random& random) {
  switch (family) {
    case Family::tiny:
      return tiny(random);
    case Family::cells:
      return cells(random);
    case Family::star:
      return star(random);
    case Family::round:
      return round_zone(random);
    case Family::corridor:
      return corridor(random);
    case Family::spiky:
      return spiky(random);
    case Family::comb:
      return comb(random);
    case Family::spiral:
      return spiral(random);
    case Family::touching:
      return touching(random);
    case Family::stairs:
      return stairs(random);
    case Family::runs:
      return runs(random);
    case Family::fence:
      return fence(random);
    case Family::huge:
    case Family::count:
      return huge(random);
  }
  return {};
}

struct Extent {
  Place low{extent_mm, extent_mm}, high{-extent_mm, -extent_mm};
};
Extent extent_of(const std::vector<Edge>& edges) {
  Extent all;
  for (const Edge& e : edges) {
    all.low = {std::min(all.low.x, e.a.x), std::min(all.low.y, e.a.y)};
    all.high = {std::max(all.high.x, e.a.x), std::max(all.high.y, e.a.y)};
  }
  return all;
}
// By `d` along one axis: nowhere, anywhere near, anywhere at all, to either end.
std::int64_t shift(std::int64_t low, std::int64_t high, Random& random) {
  const std::int64_t least = -extent_mm - low, most = extent_mm - high;
  switch (random.in(0, 4)) {
    case 0:
      return 0;
    case 1:
      return std::min(std::max(random.in(-100'000, 100'000), least), most);
    case 2:
      return random.in(least, most);
    case 3:
      return least;
    default:
      return most;
  }
}

const Edge& some_edge(const std::vector<Edge>& edges, Random& random) {
  return edges[static_cast<std::size_t>(random.in(0, static_cast<std::int64_t>(edges.size()) - 1))];
}
Place beside(Place p, Random& random) {
  return {p.x + random.in(-1, 1), p.y + random.in(-1, 1)};
}
// On the line of an edge as near as the grid has it, from one length before it to one behind.
Place along(const Edge& e, Random& random) {
  const std::int64_t k = random.in(-16, 32);
  return {e.a.x + (e.b.x - e.a.x) / 16 * k, e.a.y + (e.b.y - e.a.y) / 16 * k};
}
// As the kernel has it: positions saturate at the extent.
Place on_map(Place p) {
  const auto clamp = [](std::int64_t v) { return std::min(std::max(v, -extent_mm), extent_mm); };
  return {clamp(p.x), clamp(p.y)};
}

}  // namespace

const char* name_of(Family family) {
  static const std::array<const char*, static_cast<std::size_t>(Family::count)> names{
      "tiny",   "cells",    "star",   "round", "corridor", "spiky", "comb",
      "spiral", "touching", "stairs", "runs",  "fence",    "huge"};
  return names[static_cast<std::size_t>(family)];
}

Zone random_zone(Family family, Random& random) {
  Zone zone = local_zone(family, random);
  zone.name = name_of(family);
  const Extent extent = extent_of(edges_of(zone));
  const Place by{shift(extent.low.x, extent.high.x, random),
                 shift(extent.low.y, extent.high.y, random)};
  for (Ring& ring : zone.rings) {
    for (Place& p : ring) p = {p.x + by.x, p.y + by.y};
  }
  return zone;
}

Place uniform_place(const std::vector<Edge>& edges, Random& random) {
  const Extent extent = extent_of(edges);
  return {random.in(extent.low.x, extent.high.x), random.in(extent.low.y, extent.high.y)};
}

Place delicate_place(const std::vector<Edge>& edges, Random& random) {
  const Edge& e = some_edge(edges, random);
  switch (random.in(0, 7)) {
    case 0:
      return on_map(e.a);
    case 1:
      return on_map(beside(e.a, random));
    case 2:
      return on_map(along(e, random));
    case 3:
      return on_map(beside(along(e, random), random));
    case 4:
      return {e.a.x, some_edge(edges, random).a.y};
    case 5:
      return on_map({uniform_place(edges, random).x, e.a.y + random.in(-1, 1)});
    case 6:
      return on_map({e.a.x + random.in(-3'000, 3'000), e.a.y + random.in(-3'000, 3'000)});
    default:
      return uniform_place(edges, random);
  }
}

Edge delicate_leg(const std::vector<Edge>& edges, Random& random) {
  const Edge& e = some_edge(edges, random);
  const Place p = delicate_place(edges, random);
  switch (random.in(0, 5)) {
    case 0:
      return {on_map(along(e, random)), on_map(along(e, random))};
    case 1:
      return {on_map(beside(along(e, random), random)), on_map(beside(along(e, random), random))};
    case 2:
      return {p, on_map({2 * e.a.x - p.x, 2 * e.a.y - p.y})};  // through a vertex
    case 3:
      return {p, on_map({p.x + random.in(-20, 20), p.y + random.in(-20, 20)})};
    case 4:
      return {p, p};
    default:
      return {p, delicate_place(edges, random)};
  }
}

}  // namespace rtac::kernel_test
