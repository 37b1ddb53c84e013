// A recorded run as a file: what it starts from, then its tape.
#pragma once

#include <string>
#include <vector>

#include "run.h"

namespace rtac::simulate {

struct Trace {
  std::string specification, decision;
  std::uint64_t manifest_hash = 0;
  Setup setup;
  std::vector<std::string> tape;
  std::string about;  // a monitor; empty: all
};

std::string trace_text(const Case& all, const DecisionCase& decision, const Setup& setup,
                       const Outcome& outcome, const std::vector<std::string>& tape);
Problem read_trace(const std::string& text, const Case& all, Trace& to);

}  // namespace rtac::simulate
