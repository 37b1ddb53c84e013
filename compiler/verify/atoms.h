// What a property speaks of, and which lemmas its look-ahead rests on.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::verify {

struct Atoms {
  bool clearance = false, distance = false, charge = false, speed = false, altitude = false;
  bool agent = false, energy = false, others = false;
  bool received = false;  // the clearance of a zone that is received
  // Nothing of the above: no robot can change what it says.
  [[nodiscard]] bool only_facts() const { return !speed && !of_places(); }
  // Beside what depends on inputs.
  [[nodiscard]] bool only_speed() const { return speed && !of_places(); }

 private:
  [[nodiscard]] bool of_places() const {
    return clearance || distance || charge || altitude || agent || others || received;
  }
};
Atoms atoms_of(const ir::Block& property);

// Whether it asks anything of each of the other robots, or of how many.
bool judges_others(const ir::Block& property);

// Whether some inputs make a property hold wherever the robot is, as far as `and`, `or` and `not`
// tell.
bool may_hold_by_inputs(const ir::Block& property);

// Nothing but distances to agents, which every recovery of the module keeps where it moves.
bool asks_agents_only(const ir::Block& property);

// Names of compiler/verify/lemmas.
std::vector<std::string> lemmas_of(const Atoms& atoms, const ir::Decision& decision,
                                   const ir::Monitor& monitor);

}  // namespace rtac::verify
