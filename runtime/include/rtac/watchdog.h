// Says when a decision was not stepped in time. A decision that is not asked cannot switch, so its
// executor brakes when this expires.
#pragma once

#include "rtac/types.h"

namespace rtac {

class Watchdog {
 public:
  // Expires when more than `periods` periods passed since the last step.
  Watchdog(TimeUs period_us, int periods) : limit_us_(period_us * periods) {}

  void stepped(TimeUs now_us) { last_us_ = now_us; }
  // Before the first step nothing can be late. A clock that runs backwards counts as expired.
  [[nodiscard]] bool expired(TimeUs now_us) const {
    if (last_us_ == never_us) return false;
    return now_us < last_us_ || now_us - last_us_ > limit_us_;
  }

 private:
  TimeUs limit_us_;
  TimeUs last_us_ = never_us;
};

}  // namespace rtac
