// Every deliberately unsound variant of a decision, and the attack that kills it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rtac::campaign {

struct Row {
  const char* mutant;
  const char* spec;  // in tests/campaign/specs
  const char* adversary;
  int runs;                   // that kill it; the sound variant survives ten times as many
  const char* scenario = "";  // beside the specification; empty: none
};
const std::vector<Row>& kill_table();

struct Attack {
  int status = -1;         // of `rtac sim`: 3 is a violation
  std::uint64_t seed = 0;  // of the first run with one
  std::string depth;       // with its unit
  std::string said;
};
// `mutant` may be empty: the sound variant.
Attack attack(const Row& row, const std::string& mutant, int runs);

}  // namespace rtac::campaign
