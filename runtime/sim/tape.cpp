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

bool Tape::read(const char* word, std::vector<std::int64_t>& whole, std::vector<double>& real) {
  const std::string start = std::string(word) + " ";
  while (next_ < lines_.size() && lines_[next_].compare(0, start.size(), start) != 0) ++next_;
  if (next_ == lines_.size()) {
    if (failed_line_ < 0) failed_line_ = static_cast<int>(next_);
    return false;
  }
  const char* at = lines_[next_++].c_str() + start.size() - 1;
  const auto fails = [&](const char* after) {
    if (after != at) return false;
    if (failed_line_ < 0) failed_line_ = static_cast<int>(next_ - 1);
    return true;
  };
  for (std::int64_t& number : whole) {
    char* after = nullptr;
    number = std::strtoll(at, &after, 10);
    if (fails(after)) return false;
    at = after;
  }
  for (double& number : real) {
    char* after = nullptr;
    number = std::strtod(at, &after);
    if (fails(after)) return false;
    at = after;
  }
  return true;
}

}  // namespace rtac::sim
