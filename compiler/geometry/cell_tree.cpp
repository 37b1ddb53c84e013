#include "compiler/geometry/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>

#include "compiler/geometry/cell_distance.h"
#include "compiler/geometry/cell_words.h"

namespace rtac::geometry {
namespace {

using Edges = std::vector<PreparedEdge>;

// What one attempt may cost.
struct Terms {
  std::size_t edges_max, bytes_max;
};
// Whether a place is inside takes a look at every edge of its cell, if the boundary meets that:
// such cells are divided down to so many, with what is left as soon as distances are exact as far
// as wanted.
constexpr std::size_t met_edges_max = 3;

// The cells of the square that overlap the grid, down to those of the grid; and their neighbours.
struct Part {
  Square square;
  Candidates near;
  std::vector<Part> parts;  // 16 or none
};

// Divided by two twice, so that the second time only what matters for a quarter is looked at.
std::vector<Part> parts_of(const Square& square, const Candidates& near, const Edges& edges) {
  constexpr std::int64_t narrow_at_most_mm = std::int64_t{1} << 30;  // products would overflow
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

  friend bool operator<(const Bud& a, const Bud& b) {
    return a.turn_mm != b.turn_mm ? a.turn_mm > b.turn_mm : a.slot > b.slot;
  }
};

// One attempt: cells with too many edges are divided in the order of their distance from the
// boundary, as far as the bytes go; what remains is far. The words of the grid come first, then
// that of the whole square.
class Growth {
 public:
  Growth(const Edges& edges, const Grid& grid, const Terms& terms, std::int64_t wanted_mm)
      : edges_(edges), grid_(grid), terms_(terms), wanted_mm_(wanted_mm) {
    tree_.words.resize(grid.cells() + 1);
  }

  void grow(const Part& whole, const std::vector<char>& corners) {
    start_grid(whole, corners);
    start_outside(whole, grid_.cells(), 0);
    const std::size_t most_a_division = 16 * (1 + terms_.edges_max) * 4;
    while (!buds_.empty() && !refused_) {
      std::pop_heap(buds_.begin(), buds_.end());
      const Bud bud = std::move(buds_.back());
      buds_.pop_back();
      const bool divisible = bud.square.side_mm >= 4;  // else a part has less than 1 mm
      if (divisible && tree_.bytes() + most_a_division <= terms_.bytes_max) {
        divide(bud);
      } else if (!bud.is_leaf) {
        far(bud);
      }
    }
  }
  // Some place has too many edges, however small its cell.
  [[nodiscard]] const std::optional<TooDense>& refusal() const { return refused_; }

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
      bud.turn_mm = static_cast<double>(wanted_mm_);
      if (!is_coarse(bud)) return;
    }
    buds_.push_back(std::move(bud));
    std::push_heap(buds_.begin(), buds_.end());
  }
  // A zone with no more edges than a cell may have needs no cells.
  [[nodiscard]] bool is_coarse(const Bud& bud) const {
    return bud.near.edges.size() > met_edges_max && bud.near.meets_boundary() &&
           !outside(bud.square) && edges_.size() > cell_edges_max;
  }
  std::size_t split(std::size_t slot, std::int32_t depth) {
    const std::size_t at = tree_.words.size();
    tree_.words.resize(at + 16);
    tree_.words[slot] = split_word(at);
    tree_.depth = std::max(tree_.depth, depth + 1);
    return at;
  }
  void divide(const Bud& bud) {
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
    if (bud.near.meets_boundary()) {
      // An edge of the cell is at most its diagonal away from it: from its middle, 2.13 sides.
      const std::int64_t within_mm = bud.square.side_mm * 17 / 8 + 1;
      refused_ = TooDense{middle(bud.square), bud.near.edges.size(), within_mm};
    }
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
  static GridPoint middle(const Square& s) {
    return {static_cast<std::int32_t>(s.x_mm + s.side_mm / 2),
            static_cast<std::int32_t>(s.y_mm + s.side_mm / 2)};
  }

  const Edges& edges_;
  const Grid& grid_;
  const Terms terms_;
  const std::int64_t wanted_mm_;
  CellTree tree_;
  std::vector<Bud> buds_;  // a heap
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
    const std::size_t n = edges_.size();
    // Words have 24 bits for the places of lists.
    const std::size_t most =
        std::min<std::size_t>(cell_tree_bytes_max(n) - n * edge_bytes, 1U << 26);
    const std::size_t few =
        std::min(most, 64 * n + 2048 - n * edge_bytes);  // small zones stay small
    std::vector<Terms> attempts = {{8, few}, {cell_edges_max, few}, {8, most}};
    if (n > 20'000) attempts = {{8, few}};  // an attempt takes seconds
    attempts.push_back({cell_edges_max, most});
    std::optional<TooDense> refusal;
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      Growth growth(edges_, grid_, attempts[i], wanted_mm);
      growth.grow(whole_, corners_);
      refusal = growth.refusal();
      if (refusal) continue;
      CellTree tree = growth.take();
      const bool is_last = i + 1 == attempts.size();
      if (is_last || tree.exact_mm.value_or(INT32_MAX) >= wanted_mm) return tree;
    }
    return *refusal;
  }

 private:
  static constexpr std::size_t edge_bytes = 24;

  void divide(Part& part) {
    if (!grid_.overlaps(part.square) || part.square.side_mm <= grid_.cell_mm()) return;
    part.parts = parts_of(part.square, part.near, edges_);
    for (Part& p : part.parts) divide(p);
    if (part.near.edges.size() > cell_edges_max) part.near.edges.resize(cell_edges_max + 1);
  }

  Edges edges_;
  Grid grid_;
  std::vector<char> corners_;
  Part whole_;
};

}  // namespace

std::variant<CellTree, TooDense> grow_cell_tree(const SnappedZone& zone, std::int64_t wanted_mm) {
  return Grower(zone).run(wanted_mm);
}

}  // namespace rtac::geometry
