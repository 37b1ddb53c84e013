// The last answers to questions that take long and are asked again and again while a specification
// is analysed: for each monitor, for each pair, for what it is rechecked by.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// What a search looks at of edges and cells.
struct Drawn {
  Drawn(const std::vector<EdgeRow>& edges, const CellGrid& cells)
      : origin(cells.origin),
        cell_mm(cells.cell_mm),
        columns(cells.columns),
        rows(cells.rows),
        clearance_mm(cells.clearance_mm_lo) {
    for (const EdgeRow& e : edges) ends.insert(ends.end(), {e.a, e.b});
  }
  bool operator==(const Drawn&) const = default;

  std::vector<GridPoint> ends;
  GridPoint origin;
  std::int32_t cell_mm, columns, rows;
  std::vector<std::int32_t> clearance_mm;
};

template <class Question, class Answer>
class Kept {
 public:
  template <class Find>
  Answer find(Question question, const Find& find) {
    for (const auto& [asked, found] : last_) {
      if (asked == question) return found;
    }
    Answer found = find();
    last_.emplace_front(std::move(question), found);
    if (last_.size() > most) last_.pop_back();
    return found;
  }

 private:
  static constexpr std::size_t most = 12;
  std::deque<std::pair<Question, Answer>> last_;
};

}  // namespace rtac::geometry
