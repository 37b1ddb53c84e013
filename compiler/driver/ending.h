// Signals that end this program while something of its own is running or lies about.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace rtac::driver {

// From here on SIGINT, SIGTERM and SIGHUP end the child that is waited for; the program itself ends
// by the same signal when the last Ending goes: what was made before it is removed by then. One
// that only computes ends two seconds later all the same: the next one removes what lies about
// then. Signals that are ignored stay so, as `nohup` wants it.
class Ending {
 public:
  Ending();
  ~Ending();
  Ending(const Ending&) = delete;
  Ending& operator=(const Ending&) = delete;
};

// Starts `words` with its output in the files `out` and `err` (empty: in `out` as well) and waits.
// The child ends when this process does, however it does. 0, or an errno: it was not started.
int run_child(const std::vector<std::string>& words, const std::string& out, const std::string& err,
              int& status);

}  // namespace rtac::driver
