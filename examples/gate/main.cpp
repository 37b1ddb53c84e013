// The decision module alone, without the rest of the runtime: a gate that a program of your own
// steps once a period. The cart drives at full speed towards the wall x = 10 m, and the gate says
// when the safe controller must take over.
#include <cstdio>

#include "gate.h"
#include "rtac/decision_text.h"

int main() {
  using namespace rtac::literals;
  gate::Guard guard;
  guard.plan({});  // the policy follows no plan: the look-ahead in time decides alone

  double x = 5.0;
  for (rtac::TimeUs now_us = 0; now_us < 10'000'000; now_us += 100'000, x += 0.08) {
    guard.position({rtac::Length(x), 3_m}, now_us).velocity({0.8_mps, 0_mps}, now_us);
    const rtac::DecisionRecord& decision = guard.step(now_us);
    if (!decision.advanced()) {
      char reason[100];
      rtac::reason_text(decision, reason, sizeof reason);
      std::printf("at x = %.2f m: %s takes over, %s\n", x, rtac::mode_name(decision), reason);
      return 0;
    }
  }
  std::printf("the gate never closed\n");
  return 1;
}
