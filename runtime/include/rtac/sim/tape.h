// A run as text: everything that chance or malice decided, and what came of it. Numbers are written
// in hexadecimal, so that a run that is played again has the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rtac/types.h"

namespace rtac::sim {

class Tape {
 public:
  enum class Mode { off, record, play };
  Tape() = default;
  static Tape recorder() {
    Tape tape;
    tape.mode_ = Mode::record;
    return tape;
  }
  // The lines of a recorded run, without its head. A tape that is played is recorded as well.
  static Tape player(std::vector<std::string> lines) {
    Tape tape;
    tape.mode_ = Mode::play;
    tape.lines_ = std::move(lines);
    return tape;
  }

  [[nodiscard]] bool recording() const { return mode_ != Mode::off; }
  [[nodiscard]] bool playing() const { return mode_ == Mode::play; }
  // One line: a word and numbers.
  void write(const char* word, const std::vector<std::int64_t>& whole,
             const std::vector<double>& real);
  // The numbers of the next line that begins with `word`, those before it skipped. The first
  // `known` whole ones have to be those that are given: whose line it is. False: there is none, or
  // it has other numbers, fewer or more; nothing is changed then, and the tape has failed.
  bool read(const char* word, std::vector<std::int64_t>& whole, std::vector<double>& real,
            std::size_t known);

  [[nodiscard]] const std::vector<std::string>& written() const { return written_; }
  // Where a tape that was played cannot be followed; -1: nowhere.
  [[nodiscard]] int failed_line() const { return failed_line_; }

 private:
  static bool take(const char* at, std::vector<std::int64_t>& whole, std::vector<double>& real,
                   std::size_t known);
  Mode mode_ = Mode::off;
  std::vector<std::string> lines_, written_;
  std::size_t next_ = 0;
  int failed_line_ = -1;
};

}  // namespace rtac::sim
