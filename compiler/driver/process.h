// Starting other programs.
#pragma once

#include <string>
#include <vector>

#include "compiler/driver/ending.h"

namespace rtac::driver {

// A folder of its own below the temporary folder, removed with what is in it, also when a signal
// ends the program. After one that cannot be caught the next one removes it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& problem() const { return problem_; }  // empty: it is there

 private:
  Ending ending_;  // goes last, when the folder is removed
  std::string path_, problem_;
  int lock_ = -1;
};

struct ProgramResult {
  bool started = false;
  bool timed_out = false;
  int status = 0;       // of its exit, or 128 and the signal that ended it
  std::string problem;  // why it did not start
};
// Runs `words` and waits; what it says goes to the file `log`, or to the files `out` and `err`.
ProgramResult run_program(const std::vector<std::string>& words, const std::string& log);
ProgramResult run_program(const std::vector<std::string>& words, const std::string& out,
                          const std::string& err);
// The same, for so many seconds at most: then it is ended, with what it has started. By `timeout`.
inline constexpr const char* no_timeout =
    "no program is called `timeout` (`apt-get install coreutils`)";
ProgramResult run_within(int seconds, std::vector<std::string> words, const std::string& log);

// Processor time that programs have taken which were started here and have ended.
double core_seconds_of_children();

// What to tell of what a program has written: the first line that says something, in characters
// that control no terminal, and not more of it than anybody reads.
std::string told(const std::string& written);

}  // namespace rtac::driver
