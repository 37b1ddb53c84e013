// Says of two places whether they are on the field, which is 98 m wide before the file is edited.
#include <cstdio>

#include "field.h"

int main() {
  field::Monitors monitors;
  rtac::TimeUs now_us = 1'000'000;
  for (const double east_m : {30.0, 80.0}) {
    monitors.mower({rtac::Length(east_m), rtac::Length(50)}, now_us);
    const auto verdict = monitors.step(now_us)[field::Monitors::fence_index].verdict;
    std::printf("%.0f m east: %s\n", east_m,
                verdict == rtac::Verdict::is_true    ? "on the field"
                : verdict == rtac::Verdict::is_false ? "off the field"
                                                     : "unknown");
    now_us += 100'000;
  }
}
