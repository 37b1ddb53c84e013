// What has to hold so that the decisions of a specification keep what their monitors say (theory,
// well-formed RTA modules), and how far each of it is shown. docs/verification.md is the list.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

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
  initial,       // the invariant holds when the module is armed
};
// "P2a", "C", "joint return"
const char* name(Kind kind);

enum class Status { proved, refuted, unknown, acknowledged };
// "proved"
const char* name(Status status);

// What another program can check without knowing how it was found: a kind of statement and its
// numbers, as text (docs/verification.md, certificates).
struct Claim {
  std::string what;
  std::map<std::string, std::string> values;
};

struct Obligation {
  Kind kind{};
  std::string monitor;   // empty: of the decision
  std::string recovery;  // of `keeps`: which one drives
  Status status = Status::unknown;
  std::string method;         // how, in a few words
  std::string because;        // a sentence, with the numbers
  std::string repair;         // of what is refuted: what would work; may be empty
  std::string trace;          // of what is refuted: a run that shows it; may be empty
  std::vector<Claim> claims;  // of what is proved: all that it rests on
  std::int64_t micros = 0;    // how long it took
};
struct Decision {
  std::string name, kind;
  std::vector<Obligation> obligations;
};
struct Report {
  std::string spec;
  std::vector<Decision> decisions;
  bool complete = true;  // false: no module could be built, so that nothing but errors is told
};

// The worst of all: refuted, unknown, acknowledged, proved.
Status worst(const Report& report);

}  // namespace rtac::verify
