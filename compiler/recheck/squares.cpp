#include "compiler/recheck/squares.h"

#include <array>
#include <cstdint>
#include <map>
#include <numeric>

namespace rtac::recheck {

// Squares are told apart by their four quarters, from single cells on; one whose side is no power
// of two by four that overlap.
std::vector<int> number_squares(const std::vector<bool>& is_clear, int columns, int rows, int off) {
  constexpr std::int64_t most = 1'000'000;
  const std::int64_t width = columns + std::int64_t{2} * off, height = rows + std::int64_t{2} * off;
  std::vector<int> all(is_clear.size());
  std::iota(all.begin(), all.end(), 0);
  if (width * height > most) return all;
  // by the south-west corners of squares, of which those that reach off the rim are not asked for
  std::vector<int> numbers(static_cast<std::size_t>(width * height), 0);
  const auto at = [&](std::int64_t column, std::int64_t row) -> int& {
    return numbers[static_cast<std::size_t>(row * width + column)];
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      at(c + off, r + off) = is_clear[static_cast<std::size_t>(r * columns + c)] ? 1 : 0;
    }
  }
  using Quarters = std::array<int, 4>;
  const auto quarters = [&](std::int64_t c, std::int64_t r, std::int64_t step) {
    return Quarters{at(c, r), at(c + step, r), at(c, r + step), at(c + step, r + step)};
  };
  std::int64_t side = 1;
  const std::int64_t whole = 2 * std::int64_t{off} + 1;
  for (; 2 * side <= whole; side *= 2) {
    std::map<Quarters, int> known;
    for (std::int64_t r = 0; r + 2 * side <= height; ++r) {
      for (std::int64_t c = 0; c + 2 * side <= width; ++c) {
        at(c, r) =
            known.try_emplace(quarters(c, r, side), static_cast<int>(known.size())).first->second;
      }
    }
  }
  std::map<Quarters, int> known;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      all[static_cast<std::size_t>(r * columns + c)] =
          known.try_emplace(quarters(c, r, whole - side), static_cast<int>(known.size()))
              .first->second;
    }
  }
  return all;
}

}  // namespace rtac::recheck
