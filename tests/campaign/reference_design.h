// The decision of the theory as it stands there, in doubles: the capsule alone, against any control
// over twice delta, and a retreat that drives at 1 m/s. What it leaves to an advanced controller
// that always pushes at the nearest wall is what the generated decision is held up to.
#pragma once

namespace rtac::campaign {

struct Left {
  double percent = 0;      // of the time, that the advanced controller had
  double clearance_m = 0;  // the least
};

// In a room of 5 m by 5 m; V = 1.5 m/s, A = b = 1 m/s^2, samples and commands 20 ms late in all,
// errors of 2 cm and 2 cm/s, 50 ms of hysteresis, a decision every `period_ms`; `runs` of
// `duration_s`, each with noise of its own.
Left left_by_the_reference(int delta_ms, int period_ms, int runs, int duration_s);

}  // namespace rtac::campaign
