#include "compiler/diagnostics/excerpt.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace rtac::diag {
namespace {

constexpr std::size_t kTabWidth = 4;
constexpr std::size_t kColumnsMax = 160;    // longer lines are cut around the range
constexpr std::size_t kColumnsBefore = 40;  // kept before the range when a line is cut

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// Bytes of the well-formed UTF-8 sequence at `at`; 0 when it is malformed.
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t length = lead < 0x80U   ? 1
                             : lead < 0xC2U ? 0
                             : lead < 0xE0U ? 2
                             : lead < 0xF0U ? 3
                             : lead < 0xF5U ? 4
                                            : 0;
  if (at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[at + i])) return 0;
  }
  return length;
}

// The line cell by cell: one cell is one display column. `column_of` has one entry a byte and one
// for the end of the line.
struct Cells {
  std::vector<std::string> cells;
  std::vector<std::size_t> column_of;
};

Cells split_cells(std::string_view line) {
  Cells result;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t length = std::max<std::size_t>(sequence_length(line, at), 1);
    const bool broken = sequence_length(line, at) == 0;
    result.column_of.insert(result.column_of.end(), length, result.cells.size());
    const auto lead = static_cast<unsigned char>(line[at]);
    if (lead == '\t') {
      const std::size_t width = kTabWidth - result.cells.size() % kTabWidth;
      result.cells.insert(result.cells.end(), width, " ");
    } else if (broken || lead < 0x20U || lead == 0x7FU) {
      result.cells.emplace_back("\xEF\xBF\xBD");  // U+FFFD: never sent raw to a terminal
    } else {
      result.cells.emplace_back(line.substr(at, length));
    }
    at += length;
  }
  result.column_of.push_back(result.cells.size());
  return result;
}

}  // namespace

Excerpt make_excerpt(const SourceRange& range, const SourceManager& sources) {
  const LineColumn begin = sources.position(range.file, range.begin);
  const LineColumn end = sources.position(range.file, std::max(range.begin, range.end));
  const std::string_view line = sources.line_text(range.file, begin.line);
  const Cells cells = split_cells(line);
  const std::size_t begin_byte = std::min<std::size_t>(begin.column - 1, line.size());
  const std::size_t end_byte =
      end.line == begin.line ? std::min<std::size_t>(end.column - 1, line.size()) : line.size();

  Excerpt result;
  result.column = cells.column_of[begin_byte];
  result.carets = std::max<std::size_t>(cells.column_of[end_byte] - result.column, 1);
  std::size_t first = 0;
  std::size_t last = cells.cells.size();
  if (last > kColumnsMax) {
    if (result.column > kColumnsMax - kColumnsBefore) first = result.column - kColumnsBefore;
    last = std::min(last, first + kColumnsMax);
    result.carets = std::min(result.carets, std::max<std::size_t>(last - result.column, 1));
  }
  if (first > 0) result.line = "...";
  result.column = result.column - first + result.line.size();
  for (std::size_t i = first; i < last; ++i) result.line += cells.cells[i];
  if (last < cells.cells.size()) result.line += "...";
  return result;
}

}  // namespace rtac::diag
