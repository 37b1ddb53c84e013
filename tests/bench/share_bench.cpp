// What is left of the time to an advanced controller that drives at the fence, in the reference
// experiment of the theory, whose own shares stand beside: under any control and where its commands
// are judged, too, against the same adversaries; and what the theory's own design leaves to the one
// that always pushes.
#include "shares.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

#include "reference_design.h"
#include "tests/bench/benchmarks.h"

namespace rtac::bench {
namespace {

constexpr int clean = 0, refused = 1;

struct Series {
  bool retreats, command, one_period;
};

std::string title_of(const Series& s) {
  return std::string("Share of the advanced controller, ") +
         (s.retreats ? "retreat" : "brake and hold") +
         (s.one_period ? ", one period \u0394 ahead" : ", 2\u0394 ahead every 50 ms") +
         (s.command ? ", commands judged" : ", any control");
}

// A look-ahead that the fence has no room for is refused: nothing is given back then, as in the
// theory.
bool add_row(const campaign::TheoryRow& theory, const Series& s, const char* adversary,
             const Effort& effort, Report& report) {
  campaign::Experiment e;
  e.delta_ms = theory.delta_ms;
  e.command = s.command;
  e.retreats = s.retreats;
  e.one_period = s.one_period;
  e.adversary = adversary;
  e.duration_s = effort.share_seconds;
  const campaign::Measured m = campaign::measure(e);
  if (m.status != clean && m.status != refused) {
    std::cerr << m.said;
    return false;
  }
  char what[160], key[120];
  std::snprintf(key, sizeof key, "share_%s_%s_%s_%s_%d", s.retreats ? "retreat" : "brake",
                s.command ? "command" : "any", s.one_period ? "one_period" : "horizon", adversary,
                theory.delta_ms);
  std::snprintf(what, sizeof what, "\u0394 = %.2f s, %s; theory %.1f %%%s", theory.delta_ms / 1e3,
                adversary, s.retreats ? theory.retreat : theory.brake,
                m.status == refused ? "; refused" : "");
  report.add(key, what, m.percent, "%", 1);
  if (m.status == refused) return true;
  std::snprintf(what, sizeof what, "\u0394 = %.2f s, %s: least clearance", theory.delta_ms / 1e3,
                adversary);
  report.add(std::string(key) + "_clearance", what, m.clearance_m, "m", 2);
  return m.clearance_m > 0;
}

}  // namespace

bool measure_shares(const Effort& effort, Report& report) {
  const Series all[] = {{true, false, false}, {true, true, false}, {false, false, false},
                        {false, true, false}, {true, false, true}, {true, true, true}};
  bool good = true;
  report.section(
      "Share of the advanced controller, design of the theory, every 50 ms, push-at-fence");
  for (const campaign::TheoryRow& theory : campaign::theory_shares()) {
    const campaign::Left left = campaign::left_by_the_reference(theory.delta_ms, 50, 4, 600);
    char what[80];
    std::snprintf(what, sizeof what, "\u0394 = %.2f s", theory.delta_ms / 1e3);
    report.add("share_reference_" + std::to_string(theory.delta_ms), what, left.percent, "%", 1);
  }
  for (const Series& s : all) {
    report.section(title_of(s));
    for (const char* adversary : {"push-at-fence", "chase-fence"}) {
      for (const campaign::TheoryRow& theory : campaign::theory_shares()) {
        good = add_row(theory, s, adversary, effort, report) && good;
      }
    }
  }
  return good;
}

}  // namespace rtac::bench
