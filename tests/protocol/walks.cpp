#include "tests/protocol/walks.h"

namespace rtac::protocol::test {
namespace {

// Reasons of a kernel in the words of the model. `input` may be any that the model does not give
// for a violation.
enum Reason { none, margin, waypoint, leg, violated, within_error, input, returning, starting };

template <class Of>
std::string array(const std::string& name, const std::vector<Row>& rows, const Of& of,
                  std::size_t each = 1) {
  std::string text = "hidden byte " + name + "[" + std::to_string(rows.size() * each) + "] = {";
  for (std::size_t t = 0; t < rows.size(); ++t) {
    for (std::size_t k = 0; k < each; ++k) {
      text += std::string(t + k > 0 ? "," : "") + ((t * each + k) % 40 == 0 ? "\n  " : " ") +
              std::to_string(static_cast<int>(of(rows[t], k)));
    }
  }
  return text + "\n};\n";
}

int step_number(const Row& row) {
  const std::string step = row.step;
  return step == "on_time" ? 0 : (step == "again" ? 1 : 2);
}

constexpr const char* replayer = R"(
hidden short t;
bool quiet = 1; /* every tick of the dwell is counted */
#define at (t * MONITORS + k)
#define same_reason(number, word) (r_reason[t] == number && reason == word)
#define of_input (r_reason[t] == 6 && \
                  (reason == look_ahead || reason == starting || reason == returning))
active proctype recorded() {
  drives[0] = 1;
  do
  :: t < TICKS ->
     d_step {
       if
       :: r_step[t] == 0 -> step = on_time
       :: r_step[t] == 1 -> step = again
       :: else -> step = missed
       fi;
       surrender = r_surrender[t];
       holding = r_holding[t];
       promised = r_promised[t];
       begin_tick();
       k = 0;
       do
       :: k < MONITORS ->
          violated = r_violated[at];
          clear = r_clear[at];
          safer = r_safer[at];
          gives_back = r_gives_back[at];
          judge(k);
          k++
       :: else -> break
       od;
       decide();
       hand_over();
       k = 0;
       do
       :: k < MONITORS && engaged[k] == r_engaged[at] -> k++
       :: else -> break
       od
     };
     if
     :: k < MONITORS -> printf("DIFFERS at %d: monitor %d is engaged: %d\n", t, k, engaged[k]); break
     :: else
     fi;
     if
     :: mode != r_mode[t] -> printf("DIFFERS at %d: mode %d, not %d\n", t, mode, r_mode[t]); break
     :: mode == r_mode[t] && !(drives[mode] && commands == 1) ->
        printf("DIFFERS at %d: mode %d does not drive\n", t, mode);
        break
     :: else
     fi;
     if
     :: promised != r_promised_after[t] -> printf("DIFFERS at %d: promised %d\n", t, promised); break
     :: else
     fi;
     if
     :: same_reason(0, none) || same_reason(4, violation) || same_reason(7, returning) ||
        same_reason(8, starting) || same_reason(10, surrendered) || of_input ||
        ((r_reason[t] == 1 || r_reason[t] == 2 || r_reason[t] == 3 || r_reason[t] == 5 ||
          r_reason[t] == 9 || r_reason[t] == 11) && reason == look_ahead)
     :: else -> printf("DIFFERS at %d: reason %e, not %d\n", t, reason, r_reason[t]); break
     fi;
     t++
  :: else -> printf("%d TICKS AGREE\n", TICKS); break
  od
}
)";

}  // namespace

std::string recorded(const std::vector<Row>& rows) {
  const std::size_t monitors = rows.front().found.size();
  const auto of_found = [&](const std::string& name, bool Found::*field) {
    return array(
        name, rows, [&](const Row& r, std::size_t k) { return r.found[k].*field; }, monitors);
  };
  const auto of_row = [&](const std::string& name, const auto& field) {
    return array(name, rows, [&](const Row& r, std::size_t) { return field(r); });
  };
  return "#define TICKS " + std::to_string(rows.size()) + "\n" + of_row("r_step", step_number) +
         of_row("r_surrender", [](const Row& r) { return r.surrender; }) +
         of_row("r_holding", [](const Row& r) { return r.holding; }) +
         of_row("r_promised", [](const Row& r) { return r.promised; }) +
         of_row("r_promised_after", [](const Row& r) { return r.promised_after; }) +
         of_row("r_mode", [](const Row& r) { return r.mode; }) +
         of_row("r_reason", [](const Row& r) { return r.reason; }) +
         of_found("r_violated", &Found::violated) + of_found("r_clear", &Found::clear) +
         of_found("r_safer", &Found::safer) + of_found("r_gives_back", &Found::gives_back) +
         of_found("r_engaged", &Found::engaged) + replayer;
}

}  // namespace rtac::protocol::test
