// What has to hold so that the decisions of a specification keep what their monitors say (theory,
// well-formed RTA modules), and how far each of it is shown. docs/verification.md is the list.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/analysis/common_zone.h"
#include "compiler/analysis/told.h"
#include "compiler/diagnostics/engine.h"

namespace rtac::verify {

enum class Kind {
  p1a,           // the decision is made in time
  p1b,           // both controllers command the same output
  p2a,           // the recovery keeps the property
  p2b,           // the recovery leads to where control can be given back
  p3,            // what lets the advanced controller drive lets it drive until the next decision
  keeps,         // the recovery of one monitor keeps what another one says
  satisfiable,   // the property can be seen to hold, in spite of every error
  not_vacuous,   // and can be false
  joint_return,  // there is a place where all monitors give control back
  switching,     // somebody drives, and recoveries take over from each other in bounded turns
  initial,       // the invariant holds when the module is armed
};
// "P2a", "C", "joint return"
const char* name(Kind kind);

enum class Status { proved, refuted, unknown, acknowledged };
// "proved"
const char* name(Status status);

// How an error of the analysis refutes: "diagnostic 5013".
std::string by_diagnostic(diag::Code code);

// What another program can check without knowing how it was found: a kind of statement and its
// numbers, as text (docs/verification.md, certificates).
struct Claim {
  std::string what;
  std::map<std::string, std::string> values;
};

// Where a robot stands at the start of a run that may show something, and others beside it.
struct Start {
  std::vector<std::int64_t> place_mm;  // two coordinates, or three in space; none: anywhere
  std::vector<std::vector<std::int64_t>> others_mm{};  // of the next robots; the rest: anywhere
  std::optional<std::int64_t> battery_ppm{};           // of a full one
  bool seen_there = false;  // measured as it is: who is seen elsewhere may find a way
  std::vector<analysis::ToldInput> told{};  // inputs with which other monitors ask for nothing
};

// Robots that wait for each other: those of a start, while nobody else drives so near to one of
// them. Waiting is what recoveries have them do of their own, the k-th monitor's as mode k + 1, and
// not what inputs, agents or anything external make of it.
struct LockUp {
  std::int64_t within_mm = 0;
  std::vector<int> waiting{};  // modes
  bool errors_last = false;    // what they measure has to be off, and to stay so
};

// Recoveries that take over from each other for ever in a run of the model, or as long as inputs
// ask for one, if not of a robot. A run shows it by who drives, where others have no part in it.
struct Turns {
  std::vector<int> modes{};  // the k-th monitor's recovery as k + 1; none: who drives shows nothing
  int seen = 0;  // how often one has taken over from another one, in a run that shows it
};

// A `return when` that a monitor might have: so far from the boundary of each of these zones, by
// name.
struct LaterReturn {
  std::string monitor;
  std::map<std::string, std::int64_t> clearances_mm;
};
// A recovery of another monitor that this one might have.
struct SameRecovery {
  std::string monitor, recovery;
};
// That the `return when` of a monitor asks for so much less clearance from a zone, by its name.
struct EarlierReturn {
  std::string monitor, zone;
  std::int64_t less_mm = 0;
};
// That a recovery drives no faster than so.
struct SlowerRecovery {
  std::string recovery;
  std::int64_t mmps = 0;
};
// That a recovery lands at that height.
struct OtherLanding {
  std::string recovery;
  std::int64_t height_mm = 0;
};
// That a recovery moves within what all of these have in common, where it moves within `from`.
struct OtherZone {
  std::string recovery;
  sema::ZoneId from{};
  std::vector<analysis::DeclaredPart> parts{};
};
// That a zone, by its name, is so much wider on every side.
struct WiderZone {
  std::string zone;
  std::int64_t by_mm = 0;
};
// That a zone, by its name, which is a rectangle, has so much more room on both of its long sides:
// the least that works is looked for.
struct RoomToPass {
  std::string zone;
  std::int64_t by_mm = 0;
};
// That the property of a monitor asks for no more than so much distance between robots: the most
// that works is looked for.
struct LessApart {
  std::string monitor;
  std::int64_t most_mm = 0;
};
// That others may keep robots of a kind waiting for so long.
struct LongerWait {
  std::string kind;
  std::int64_t seconds = 0;
};
// What may be written in another way.
using Mend = std::variant<LaterReturn, SameRecovery, EarlierReturn, SlowerRecovery, OtherLanding,
                          OtherZone, WiderZone, RoomToPass, LessApart, LongerWait>;

struct Obligation {
  Kind kind{};
  std::string monitor;   // empty: of the decision
  std::string recovery;  // of `keeps`: which one drives
  Status status = Status::unknown;
  std::string method;          // how, in a few words
  std::string because;         // a sentence, with the numbers
  std::string repair;          // of what is refuted: what would work; may be empty
  std::string trace;           // of what is refuted: a run that shows it; may be empty
  std::vector<Claim> claims;   // of what is proved: all that it rests on
  std::string model;           // of `switching`, proved or acknowledged: what the claims hold of
  std::int64_t micros = 0;     // how long it took
  std::string not_shown{};     // of what is refuted: why there is no run
  std::string not_recorded{};  // of what a run shows: why there is no `trace`
  std::optional<Turns> in_turns{};  // of `switching`, unknown
  // Which of these may mend what is open; nothing is claimed of them.
  std::vector<Mend> mends{};
  // What works of them is said beside `repair`, and does not replace it; and what is where none
  // does.
  bool besides = false;
  std::string or_else{};
  // Of what is acknowledged: by a limit on what others do, which a run may show to be broken; and
  // whether runs were played.
  bool declared = false, played = false;
  // Of what is declared: the dock that robots wait for, in mm, and whose it is.
  struct Dock {
    std::string robot;
    std::pair<std::int64_t, std::int64_t> at_mm;
  };
  std::optional<Dock> dock{};
  // Of what is refuted: where a robot would be in trouble, in mm; of `keeps`, by a recovery that
  // leads nowhere from there.
  std::optional<std::pair<std::int64_t, std::int64_t>> place_mm{};
  // Of what is refuted: nothing but a run shows it, and without one it is unknown.
  bool by_a_run = false;
  std::optional<LockUp> lock_up{};  // of P2b, which a run shows
  // Of P2b: how long a run waits for control, at least, before it counts as never given back. Of
  // P2a, of what takes charge on its way: how long that way takes.
  std::int64_t patience_s = 0;
  // Of what is refuted: from where it may be seen, of `keeps` that the recovery leads out of what
  // the property says; the likeliest first.
  std::vector<Start> starts{};
  // Of what is refuted of a fleet: where robots begin of which none of these places says it, in mm.
  std::vector<std::vector<std::int64_t>> aside_mm{};
  // Of `keeps`, refuted: inputs that stay as they are, or agents that stay where they are, have the
  // recovery drive until the charge is gone.
  bool unending = false;
  // Of `keeps`, and of turns: the monitor that the recovery drives for, if it is one of inputs
  // alone.
  std::string unmet{};
  // Of `keeps`, where it depends on that: the monitors that the recovery drives for.
  std::vector<std::string> engaged{};
};
// How much of what a monitor keeps free the worst motion needs that a search has found, from states
// that just pass its look-ahead. It refutes, and proves nothing.
struct Conservatism {
  std::string monitor;
  std::string why_not;              // not measured; empty: it was
  double found_m = 0, bound_m = 0;  // at the state with the largest share
  double speed_mps = 0;             // there
  double ahead_s = 0;               // from the sample until the brake acts
  std::string by;                   // "Ipopt" or "restarts"
  int states = 0, searches = 0, failures = 0;
  bool complete = true;  // false: the time was up
  [[nodiscard]] double share() const { return found_m / bound_m; }
};
struct Decision {
  std::string name, kind;
  std::vector<Obligation> obligations;
  std::vector<Conservatism> conservatism;  // by monitor; empty: nobody asked
};
struct Report {
  std::string spec;
  std::vector<Decision> decisions;
  bool complete = true;     // false: no module could be built, so that nothing but errors is told
  std::int64_t micros = 0;  // how long all of it took, reading and tables among it
};

// The worst of all: refuted, unknown, acknowledged, proved.
Status worst(const Report& report);

}  // namespace rtac::verify
