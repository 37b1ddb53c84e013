// The last answers to questions that take long and are asked again and again while a specification
// is analysed: for each monitor, for each pair, for what it is rechecked by.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/looks.h"

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
    const auto known = std::ranges::find(last_, question, &Known::question);
    if (known != last_.end()) {
      // what is not asked any more is forgotten first
      std::rotate(last_.begin(), known, known + 1);
      looks() += last_.front().looks;
      return last_.front().answer;
    }
    const std::int64_t before = looks();
    Answer found = find();
    last_.push_front({std::move(question), found, looks() - before});
    if (last_.size() > most) last_.pop_back();
    return found;
  }

 private:
  static constexpr std::size_t most = 12;
  struct Known {
    Question question;
    Answer answer;
    std::int64_t looks;  // that it took
  };
  std::deque<Known> last_;
};

}  // namespace rtac::geometry
