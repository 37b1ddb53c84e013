#include "compiler/ir/edge_tree.h"

#include <algorithm>

namespace rtac::ir {
namespace {

class TreeChecker {
 public:
  TreeChecker(const EdgeTree& tree, std::size_t edges) : tree_(tree), edges_(edges) {}

  [[nodiscard]] bool is_good() {
    const auto grid =
        static_cast<std::size_t>(tree_.columns) * static_cast<std::size_t>(tree_.rows);
    if (tree_.columns < 1 || tree_.rows < 1 || tree_.words.size() <= grid) return false;
    if (tree_.shift < 2 || tree_.shift > 32 || tree_.shift % 2 != 0) return false;
    for (std::size_t i = 0; i < grid; ++i) {
      if (!is_good(i, tree_.shift, 0)) return false;
    }
    return is_good(grid, 32, 0) && leaves_ <= tree_.leaves;
  }

 private:
  [[nodiscard]] bool is_good(std::size_t at, std::int32_t shift, std::int32_t depth) {
    const std::uint32_t word = tree_.words[at];
    if (word >> 30 != 3) ++leaves_;
    const std::size_t first = word & 0xffffff, count = (word >> 24 & 15) + 1;
    switch (word >> 30) {
      case 0:
        return (word >> 28 & 1) == 0 || sides_are_good(word);
      case 1:
        return first + count <= edges_;
      case 2:
        return first + count <= tree_.lists.size() &&
               std::all_of(tree_.lists.begin() + std::ptrdiff_t(first),
                           tree_.lists.begin() + std::ptrdiff_t(first + count),
                           [&](std::uint32_t e) { return e < edges_; });
      default:
        return (word & 0x3fffffff) > at && are_good(word & 0x3fffffff, shift - 2, depth + 1);
    }
  }
  [[nodiscard]] bool sides_are_good(std::uint32_t word) const {
    const std::size_t first = word & 0x7fffff, count = (word >> 24 & 3) + 1;
    return first + count <= edges_ && (word >> 26 & 3) + (word >> 23 & 1) < count;
  }
  // Parts come after what they are parts of, so that there is no way back.
  [[nodiscard]] bool are_good(std::size_t first, std::int32_t shift, std::int32_t depth) {
    if (shift < 0 || depth > tree_.depth || first + 16 > tree_.words.size()) return false;
    for (std::size_t i = first; i < first + 16; ++i) {
      if (!is_good(i, shift, depth)) return false;
    }
    return true;
  }

  const EdgeTree& tree_;
  std::size_t edges_;
  std::int32_t leaves_ = 0;
};

}  // namespace

bool leads_to_edges(const EdgeTree& tree, std::size_t edges) {
  if (tree.words.empty()) return edges <= edges_without_tree;
  return TreeChecker(tree, edges).is_good();
}

}  // namespace rtac::ir
