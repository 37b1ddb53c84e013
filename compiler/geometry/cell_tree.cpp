#include "compiler/geometry/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <unordered_map>

#include "compiler/geometry/cell_distance.h"
#include "compiler/geometry/cell_need.h"
#include "compiler/geometry/cell_sides.h"
#include "compiler/geometry/cell_words.h"

namespace rtac::geometry {
namespace {

using Edges = std::vector<PreparedEdge>;

// What one attempt may cost.
struct Terms {
  std::size_t edges_max, bytes_max;

  // As many as may still be made, if each takes no more than the words of its parts.
  [[nodiscard]] std::size_t divisions_left(std::size_t bytes) const {
    const std::size_t most_a_division = division_bytes * (1 + edges_max);
    if (bytes + most_a_division > bytes_max) return 0;
    return (bytes_max - bytes - most_a_division) / division_bytes + 1;
  }
  static constexpr std::size_t division_bytes = 64;
};
// Whether a place is inside takes a look at every edge of its cell, if the boundary meets that:
// such cells are divided down to so many, with what is left as soon as distances are exact as far
// as wanted.
constexpr std::size_t met_edges_max = 2;
// How far away it is takes a look at every edge of any cell. With bytes left, distances are exact
// up to here and about the zone; then other cells are divided too, in zones that are small enough
// for the time it takes, in turn with those that make distances exact farther away.
constexpr std::int64_t spare_exact_mm = 50'000;
constexpr std::size_t near_edges_max = 4, near_zone_edges_max = 20'000;

// How far distances are exact before cells that the boundary meets are divided; and before others
// are.
struct Exact {
  double wanted_mm, ample_mm;
};
Exact exact_for(std::int64_t wanted_mm, const Grid& grid, std::size_t edges) {
  const double about_mm = edges <= near_zone_edges_max ? grid.diameter_mm() / 2 : 0;
  return {double(wanted_mm), std::max({double(wanted_mm), double(spare_exact_mm), about_mm})};
}

// The cells of the square that overlap the grid, down to those of the grid; and their neighbours.
struct Part {
  Square square;
  Candidates near;
  std::vector<Part> parts;  // 16 or none
  std::size_t due = 0;      // divisions of cells of the grid in it, at least
};
constexpr std::int64_t narrow_at_most_mm = std::int64_t{1} << 30;  // products would overflow

// Divided by two twice, so that the second time only what matters for a quarter is looked at.
std::vector<Part> parts_of(const Square& square, const Candidates& near, const Edges& edges) {
  std::vector<Part> parts(16);
  const std::int64_t half = square.side_mm / 2, quarter = square.side_mm / 4;
  const auto narrowed = [&](const Square& s, const Candidates& from) {
    return s.side_mm > narrow_at_most_mm ? from : sharpen(s, edges, narrow(s, edges, from.edges));
  };
  for (std::size_t q = 0; q < 4; ++q) {
    const std::int64_t x = square.x_mm + static_cast<std::int64_t>(q % 2) * half;
    const std::int64_t y = square.y_mm + static_cast<std::int64_t>(q / 2) * half;
    const Candidates of_half = narrowed({x, y, half}, near);
    for (std::size_t p = 0; p < 4; ++p) {
      Part& part = parts[(q / 2 * 2 + p / 2) * 4 + q % 2 * 2 + p % 2];
      part.square = {x + static_cast<std::int64_t>(p % 2) * quarter,
                     y + static_cast<std::int64_t>(p / 2) * quarter, quarter};
      part.near = narrowed(part.square, of_half);
    }
  }
  return parts;
}

// Divisions of `cells` cells that cover the square, at least, until the boundary meets none of more
// than `edges_max` edges.
std::size_t divisions_due_in(const Square& square, const Candidates& near, const Edges& edges,
                             std::size_t edges_max, double cells) {
  const bool many = near.meets_boundary() && near.edges.size() > edges_max;
  if (!many || square.side_mm > narrow_at_most_mm) return 0;
  return divisions_due(cells_due(square, met_by(square, edges, near.edges), edges_max), cells);
}

bool is_divisible(const Square& square) {
  return square.side_mm >= 4;  // else a part has less than 1 mm
}

// Somewhere in the square, in as narrow a cell as has too many edges: where to mend the outline.
TooDense densest(Square square, Candidates near, const Edges& edges) {
  while (is_divisible(square)) {
    std::vector<Part> parts = parts_of(square, near, edges);
    const auto dense = [](const Part& p) {
      return p.near.meets_boundary() ? p.near.edges.size() : 0;
    };
    Part& most = *std::ranges::max_element(parts, {}, dense);
    if (dense(most) <= cell_edges_max) break;
    square = most.square;
    near = std::move(most.near);
  }
  const GridPoint middle{static_cast<std::int32_t>(square.x_mm + square.side_mm / 2),
                         static_cast<std::int32_t>(square.y_mm + square.side_mm / 2)};
  // An edge of a cell is at most its diagonal away from it: from its middle, 2.13 sides.
  return {middle, near.edges.size(), square.side_mm * 17 / 8 + 1, 0};
}

// A cell whose word is still to be found.
struct Bud {
  std::size_t slot;  // of its word
  Square square;
  Candidates near;
  bool inside;         // its corner
  std::int32_t depth;  // divisions above it
  // The next one to be divided is that which is nearest to the boundary; one that is a leaf already
  // counts as this far away.
  double turn_mm = near.least_nearest;
  bool is_leaf = false;
  std::size_t due = 0;  // divisions that it takes, at least

  friend bool operator<(const Bud& a, const Bud& b) {
    return a.turn_mm != b.turn_mm ? a.turn_mm > b.turn_mm : a.slot > b.slot;
  }
};

// One attempt: cells with too many edges are divided in the order of their distance from the
// boundary, as far as the bytes go; what remains is far. The words of the grid come first, then
// that of the whole square.
class Growth {
 public:
  Growth(const Edges& edges, const Grid& grid, const Terms& terms, const Exact& exact)
      : edges_(edges), grid_(grid), terms_(terms), exact_(exact) {
    tree_.words.resize(grid.cells() + 1);
  }

  void grow(const Part& whole, const std::vector<char>& corners) {
    start_grid(whole, corners);
    start_outside(whole, grid_.cells(), 0);
    while (!buds_.empty() && !refused_) {
      const std::size_t left = divisions_left();
      if (due_ > left) return refuse();
      if (left == 0) return drop_all_but(0);
      if (buds_.size() > 2 * left + 1000) drop_all_but(left);
      std::pop_heap(buds_.begin(), buds_.end());
      const Bud bud = std::move(buds_.back());
      buds_.pop_back();
      due_ -= bud.due;
      divide(bud);
    }
  }
  // Some place has too many edges, however small its cell, or cells take too many bytes.
  [[nodiscard]] const std::optional<TooDense>& refusal() const { return refused_; }
  // What a cell must be allowed to have for there to be a tree, whatever its bytes.
  [[nodiscard]] std::size_t edges_due() const { return edges_due_; }
  [[nodiscard]] std::size_t divided() const { return divided_; }

  CellTree take() {
    tree_.x_mm = static_cast<std::int32_t>(grid_.x_mm);
    tree_.y_mm = static_cast<std::int32_t>(grid_.y_mm);
    tree_.shift = grid_.shift;
    tree_.column = static_cast<std::int32_t>(grid_.column);
    tree_.row = static_cast<std::int32_t>(grid_.row);
    tree_.columns = static_cast<std::int32_t>(grid_.columns);
    tree_.rows = static_cast<std::int32_t>(grid_.rows);
    for (const std::uint32_t word : tree_.words) {
      tree_.edges_most = std::max(tree_.edges_most, edges_of(word));
    }
    return std::move(tree_);
  }

 private:
  void start_grid(const Part& part, const std::vector<char>& corners) {
    for (const Part& p : part.parts) start_grid(p, corners);
    if (const auto at = grid_.index(part.square)) {
      start({*at, part.square, part.near, corners[*at] != 0, 0});
    }
  }
  // Cells that are not in the grid; what they share with the grid is never asked for.
  void start_outside(const Part& part, std::size_t slot, std::int32_t depth) {
    if (grid_.index(part.square)) {
      ++tree_.leaves;  // a word that nothing leads to
      return;
    }
    if (part.near.edges.size() <= terms_.edges_max || part.parts.empty()) {
      start({slot, part.square, part.near, false, depth});
      return;
    }
    const std::size_t at = split(slot, depth);
    for (std::size_t i = 0; i < 16; ++i) start_outside(part.parts[i], at + i, depth + 1);
  }

  void start(Bud bud) {
    if (bud.near.edges.size() <= terms_.edges_max) {
      tree_.words[bud.slot] = leaf(bud);
      bud.is_leaf = true;
      if (!is_coarse(bud)) return;
      bud.turn_mm =
          bud.near.meets_boundary() ? exact_.wanted_mm : exact_.ample_mm + bud.near.least_nearest;
    } else if (bud.near.meets_boundary()) {
      if (!is_divisible(bud.square)) return refuse(bud);
      const std::size_t due = divisions_due_in(bud.square, bud.near, edges_, terms_.edges_max, 1);
      bud.due = std::max<std::size_t>(1, due);
    }
    if (!is_divisible(bud.square)) return end(bud);
    due_ += bud.due;
    bud.near.nearest = {};  // there may be many buds
    bud.near.edges.shrink_to_fit();
    buds_.push_back(std::move(bud));
    std::push_heap(buds_.begin(), buds_.end());
  }
  [[nodiscard]] std::size_t divisions_left() const { return terms_.divisions_left(tree_.bytes()); }
  // Those that the boundary meets are divided before all others, and take more than is left.
  void refuse() {
    const Bud& most = *std::ranges::max_element(buds_, {}, &Bud::due);
    refused_ = densest(most.square, most.near, edges_);
  }
  void refuse(const Bud& indivisible) {
    edges_due_ = indivisible.near.edges.size();
    refused_ = densest(indivisible.square, indivisible.near, edges_);
  }
  // Of the others none will be divided: that takes bytes for each one before it.
  void drop_all_but(std::size_t first) {
    const auto kept = buds_.begin() + static_cast<std::ptrdiff_t>(first);
    std::nth_element(buds_.begin(), kept, buds_.end(),
                     [](const Bud& a, const Bud& b) { return b < a; });
    std::for_each(kept, buds_.end(), [this](const Bud& bud) { end(bud); });
    buds_.erase(kept, buds_.end());
    std::make_heap(buds_.begin(), buds_.end());
  }
  void end(const Bud& bud) {
    if (!bud.is_leaf) far(bud);
  }
  // A zone with no more edges than a cell may have needs no cells.
  [[nodiscard]] bool is_coarse(const Bud& bud) const {
    if (outside(bud.square) || edges_.size() <= cell_edges_max) return false;
    if (bud.near.meets_boundary()) {
      return bud.near.edges.size() > met_edges_max && !tells_by_sides(tree_.words[bud.slot]);
    }
    return bud.near.edges.size() > near_edges_max && edges_.size() <= near_zone_edges_max;
  }
  std::size_t split(std::size_t slot, std::int32_t depth) {
    // At a multiple of 16, so that parts fill a line of a cache.
    const std::size_t at = (tree_.words.size() + 15) / 16 * 16;
    tree_.words.resize(at + 16);
    tree_.words[slot] = split_word(at);
    tree_.depth = std::max(tree_.depth, depth + 1);
    return at;
  }
  void divide(const Bud& bud) {
    ++divided_;
    const std::size_t at = split(bud.slot, bud.depth);
    tree_.leaves -= bud.is_leaf ? 1 : 0;
    const Corner from{bud.square.x_mm, bud.square.y_mm};
    std::vector<Part> parts = parts_of(bud.square, bud.near, edges_);
    for (std::size_t i = 0; i < 16; ++i) {
      const Square& square = parts[i].square;
      bool inside = bud.inside;
      for (const std::uint32_t e : bud.near.edges) {
        inside ^= crosses_way(edges_[e], from, {square.x_mm, square.y_mm});
      }
      start({at + i, square, std::move(parts[i].near), inside, bud.depth + 1});
    }
  }

  void far(const Bud& bud) {
    const double distance_mm = bud.near.least_nearest;
    ++tree_.leaves;
    const auto down = static_cast<std::int32_t>(
        std::clamp<double>(distance_mm * (1 - 1e-9) - 1e-3, 0, far_most_mm));
    tree_.words[bud.slot] = far_word(down, bud.inside);
    if (bud.square.side_mm < 2) return;  // known to the mm as well
    const auto at_most = [&](std::optional<std::int32_t>& exact) {
      exact = std::min(exact.value_or(down), down);
    };
    at_most(tree_.exact_mm);
    if (bud.inside) at_most(tree_.exact_inside_mm);
  }
  std::uint32_t leaf(const Bud& bud) {
    const std::vector<std::uint32_t>& near = bud.near.edges;
    const bool crossed = bud.near.meets_boundary() && !outside(bud.square) &&
                         std::any_of(near.begin(), near.end(), [&](std::uint32_t e) {
                           return meets_closed(bud.square, edges_[e]);
                         });
    ++tree_.leaves;
    // Edges that lie between them in number do no harm, and need no list.
    const std::size_t run = near.back() - near.front() + 1;
    const bool is_run = run <= terms_.edges_max;
    if (crossed && run <= sides_edges_max && near.front() <= sides_first_max) {
      const Sides sides = sides_of(bud.square, std::span(edges_).subspan(near.front(), run));
      if (sides.edges > 0) return sides_word(near.front(), run, sides);
    }
    return is_run ? run_word(near.front(), run, bud.inside, crossed)
                  : list_word(list(near), near.size(), bud.inside, crossed);
  }
  // Wider than the cells of the grid: it lies outside, but for what it shares with the grid.
  [[nodiscard]] bool outside(const Square& square) const {
    return square.side_mm > grid_.cell_mm();
  }
  // Neighbouring cells often have the same edges.
  std::size_t list(const std::vector<std::uint32_t>& near) {
    const auto [at, is_new] =
        lists_.try_emplace(std::u32string(near.begin(), near.end()), tree_.lists.size());
    if (is_new) tree_.lists.insert(tree_.lists.end(), near.begin(), near.end());
    return at->second;
  }

  const Edges& edges_;
  const Grid& grid_;
  const Terms terms_;
  const Exact exact_;
  CellTree tree_;
  std::vector<Bud> buds_;  // a heap, all of them divisible
  std::size_t due_ = 0;    // divisions that they take, at least
  std::size_t edges_due_ = 0, divided_ = 0;
  std::unordered_map<std::u32string, std::size_t> lists_;
  std::optional<TooDense> refused_;
};

// What every attempt starts from, and the attempts.
class Grower {
 public:
  explicit Grower(const SnappedZone& zone)
      : edges_(prepare_edges(zone)),
        grid_(grid_for(edges_)),
        corners_(corners_inside(edges_, grid_)) {
    whole_.square = {grid_.x_mm, grid_.y_mm, std::int64_t{1} << square_shift};
    whole_.near.edges.resize(edges_.size());
    std::iota(whole_.near.edges.begin(), whole_.near.edges.end(), 0U);
    divide(whole_);
  }

  std::variant<CellTree, TooDense> run(std::int64_t wanted_mm) {
    if (refused_) return refused();
    const std::size_t n = edges_.size();
    const std::size_t most = bytes_most();
    // Small zones stay small.
    const std::size_t few = std::min(most, 128 * n + 2048 - n * edge_bytes);
    const Exact exact = exact_for(wanted_mm, grid_, n);
    std::vector<Terms> attempts = {{8, few}, {cell_edges_max, few}, {8, most}};
    if (n > 20'000) attempts = {{8, few}};  // an attempt takes seconds
    attempts.push_back({cell_edges_max, most});
    std::size_t edges_due = 0;
    for (std::size_t i = 0; i < attempts.size() && edges_due <= cell_edges_max; ++i) {
      if (attempts[i].edges_max < edges_due) continue;
      Growth growth(edges_, grid_, attempts[i], exact);
      growth.grow(whole_, corners_);
      refused_ = growth.refusal();
      edges_due = std::max(edges_due, growth.edges_due());
      divided_ += growth.divided();
      if (refused_) continue;
      CellTree tree = growth.take();
      const bool is_last = i + 1 == attempts.size();
      if (is_last || tree.exact_mm.value_or(INT32_MAX) >= exact.ample_mm) return tree;
    }
    return refused();
  }

 private:
  static constexpr std::size_t edge_bytes = 24;

  TooDense refused() {
    refused_->divided = divided_;
    return *refused_;
  }
  [[nodiscard]] std::size_t bytes_most() const {
    const std::size_t n = edges_.size();
    // Words have 24 bits for the places of lists.
    return std::min<std::size_t>(cell_tree_bytes_max(n) - n * edge_bytes, 1U << 26);
  }
  void divide(Part& part) {
    if (refused_ || !grid_.overlaps(part.square) || part.square.side_mm <= grid_.cell_mm()) return;
    part.parts = parts_of(part.square, part.near, edges_);
    ++divided_;
    due_ -= part.due;
    for (Part& p : part.parts) {
      p.near.nearest = {};
      const double across = double(p.square.side_mm) / double(grid_.cell_mm());
      p.due = divisions_due_in(p.square, p.near, edges_, cell_edges_max, across * across);
      due_ += p.due;
    }
    const Terms widest{cell_edges_max, bytes_most()};
    if (due_ > widest.divisions_left(grid_.cells() * 4)) {
      const Part& most = *std::ranges::max_element(part.parts, {}, &Part::due);
      refused_ = densest(most.square, most.near, edges_);
      return;
    }
    for (Part& p : part.parts) divide(p);
    if (part.near.edges.size() > cell_edges_max) part.near.edges.resize(cell_edges_max + 1);
  }

  Edges edges_;
  Grid grid_;
  std::vector<char> corners_;
  Part whole_;
  std::size_t due_ = 0;  // divisions of cells of the grid, at least
  std::size_t divided_ = 0;
  std::optional<TooDense> refused_;  // no attempt will succeed; or the last one did not
};

}  // namespace

std::variant<CellTree, TooDense> grow_cell_tree(const SnappedZone& zone, std::int64_t wanted_mm) {
  return Grower(zone).run(wanted_mm);
}

}  // namespace rtac::geometry
