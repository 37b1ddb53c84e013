#include "rtac/sim/tape.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace rtac::sim {

void Tape::write(const char* word, const std::vector<std::int64_t>& whole,
                 const std::vector<double>& real) {
  if (!recording()) return;
  constexpr std::size_t widest = 32;
  char text[widest];
  std::string line = word;
  for (const std::int64_t number : whole) {
    std::snprintf(text, widest, " %" PRId64, number);
    line += text;
  }
  for (const double number : real) {
    std::snprintf(text, widest, " %a", number);
    line += text;
  }
  written_.push_back(std::move(line));
}

bool Tape::read(const char* word, std::vector<std::int64_t>& whole, std::vector<double>& real,
                std::size_t known) {
  const std::string start = std::string(word) + " ";
  while (next_ < lines_.size() && lines_[next_].compare(0, start.size(), start) != 0) ++next_;
  const bool fits =
      next_ < lines_.size() && take(lines_[next_].c_str() + start.size() - 1, whole, real, known);
  if (!fits && failed_line_ < 0) failed_line_ = static_cast<int>(next_);
  if (next_ < lines_.size()) ++next_;
  return fits;
}

// The whole line, or nothing of it.
bool Tape::take(const char* at, std::vector<std::int64_t>& whole, std::vector<double>& real,
                std::size_t known) {
  std::vector<std::int64_t> found_whole;
  std::vector<double> found_real;
  char* after = nullptr;
  for (std::size_t k = 0; k < whole.size(); ++k, at = after) {
    found_whole.push_back(std::strtoll(at, &after, 10));
    if (after == at || (k < known && found_whole[k] != whole[k])) return false;
  }
  for (std::size_t k = 0; k < real.size(); ++k, at = after) {
    found_real.push_back(std::strtod(at, &after));
    if (after == at) return false;
  }
  if (*at != '\0') return false;
  whole.swap(found_whole);
  real.swap(found_real);
  return true;
}

}  // namespace rtac::sim
