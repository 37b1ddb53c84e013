// The reference experiment of the theory, by the program as users have it: how much of the time is
// left to an advanced controller that drives at the fence.
#pragma once

#include <string>
#include <vector>

namespace rtac::campaign {

// The theory's own shares, in percent, under any control over 2 delta, for orientation.
struct TheoryRow {
  int delta_ms;
  double brake, retreat;
  double clearance_m;  // the least of the retreat; less than none: nothing to measure
};
const std::vector<TheoryRow>& theory_shares();

struct Experiment {
  int delta_ms = 50;      // 2 delta is looked ahead
  bool command = false;   // what is commanded is judged, too
  bool retreats = true;   // else it brakes and holds its place
  const char* adversary;  // of `rtac sim`
  int runs = 4, duration_s = 600;
  // The decision looks one period ahead, which is delta; else its period is 50 ms, and so is the
  // hysteresis.
  bool one_period = false;
};
struct Measured {
  int status = -1;         // of `rtac sim`: 0 is that nobody left the fence, 1 that it is refused
  double percent = 0;      // of the time, that the advanced controller had
  double clearance_m = 0;  // the least, of the body, by the true state
  std::string said;
};
Measured measure(const Experiment& experiment);

}  // namespace rtac::campaign
