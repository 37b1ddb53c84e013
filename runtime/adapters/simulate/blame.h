// Who drove into a violation. A property that fails while one recovery drives says nothing of
// another one, whose pair with it `rtac verify` asks about.
#pragma once

#include <cstddef>
#include <vector>

#include "rtac/decision.h"

namespace rtac::simulate {

// Of one robot, and of a monitor. Modes are those of decisions: 0 is the advanced controller, k the
// recovery of monitor k - 1.
struct Drove {
  int held = 0;             // when the look-ahead held for the last time
  int free = 0;             // when the monitor was not engaged for the last time
  int last = 0;             // at the end
  std::vector<bool> modes;  // whether each of them has driven since it was not engaged
  bool holds = false;       // the look-ahead holds now
};

class Blame {
 public:
  Blame(std::size_t robots, std::size_t monitors);
  void decided(const DecisionRecord& record);
  // Until then nobody drives some robot: its first tick is late.
  [[nodiscard]] bool everybody_has_decided() const { return undecided_ == 0; }
  // Of the robot whose property is false, and of those whose look-ahead fails as well: of two that
  // are too close to each other, either may have come closer.
  [[nodiscard]] std::vector<Drove> who(int monitor, int robot) const;

 private:
  std::vector<std::vector<Drove>> of_robot_;  // by monitor
  std::vector<bool> has_decided_;
  std::size_t undecided_;
};

// By mode; empty: nobody is asked for, or ruled out.
struct Asked {
  std::vector<bool> driven_by, not_driven_by;
};
// One of the robots was driven as is asked for at the violation, or when its look-ahead held or its
// monitor was not engaged for the last time, and since the latter by nobody who is ruled out. Who
// spends the charge for the way home makes the way home fail.
bool as_asked(const Asked& asked, const std::vector<Drove>& who);

}  // namespace rtac::simulate
