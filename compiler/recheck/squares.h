// Places of a grid around which the same cells are clear.
#pragma once

#include <vector>

namespace rtac::recheck {

// For each cell, row by row, a number of which cells are so in the square around it that reaches
// `off` cells to each side: two have the same only where the squares agree, cell by cell. Off the
// grid none is. Where that takes too many numbers, each cell has its own.
std::vector<int> number_squares(const std::vector<bool>& is_clear, int columns, int rows, int off);

}  // namespace rtac::recheck
