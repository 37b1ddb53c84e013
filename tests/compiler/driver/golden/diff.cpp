#include "tests/compiler/driver/golden/diff.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rtac::golden {
namespace {

constexpr std::size_t context_lines = 3;
constexpr std::size_t shown_lines = 30;  // of either side: more does not fit a screen

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) {
      lines.push_back(text.substr(begin) + " (no line break at the end)");
      break;
    }
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

void print(const std::vector<std::string>& lines, std::size_t begin, std::size_t end,
           const char* mark, std::string& out) {
  const std::size_t stop = std::min(end, begin + shown_lines);
  for (std::size_t i = begin; i < stop; ++i) out += mark + lines[i] + "\n";
  if (stop < end) out += mark + ("... " + std::to_string(end - stop)) + " more lines\n";
}

}  // namespace

std::string excerpt(const std::string& name, const std::string& expected,
                    const std::string& actual) {
  if (expected == actual) return "";
  const std::vector<std::string> a = lines_of(expected), b = lines_of(actual);
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t head = 0;
  while (head < shorter && a[head] == b[head]) ++head;
  std::size_t tail = 0;
  while (tail < shorter - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) ++tail;
  const std::size_t from = head - std::min(head, context_lines);
  std::string out = "--- " + name + " (expected)\n+++ " + name + " (actual)\n@@ line " +
                    std::to_string(head + 1) + " @@\n";
  print(a, from, head, "  ", out);
  print(a, head, a.size() - tail, "- ", out);
  print(b, head, b.size() - tail, "+ ", out);
  print(a, a.size() - tail, a.size() - tail + std::min(tail, context_lines), "  ", out);
  return out;
}

}  // namespace rtac::golden
