// Robots that cannot be at their docks at once: they are charged one after the other, and who waits
// for the others does so within `held` (language rule 6.7).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

struct Docking {
  std::string site;
  // Of the dock in front of which most robots wait: whose it is, where, and how many these are.
  std::string robot;
  std::pair<std::int64_t, std::int64_t> at_mm{};
  std::int64_t before = 0;
  // Up to which a `return when` has each of them charged, of a full battery, and how long that
  // takes at least, from nothing on; 0: none says anything of that, and nobody waits there for
  // long.
  std::int64_t level_ppm = 0, each_s = 0;
  [[nodiscard]] bool in_turn() const { return before > 0; }
  [[nodiscard]] std::int64_t wait_s() const { return before * each_s; }
};
// Of a monitor whose recovery leads to where it is charged. Where the number of robots is not known
// nobody is before another one.
Docking docking_of(const Subject& s, const ir::Monitor& charge);

// A `held` for which all others may be charged first. They come and go, too, which may take as long
// again.
std::vector<Mend> longer_waits(const Subject& s, const Docking& docking);

// Where `held` is shorter than that: a run may refute it, and nothing shows it.
Obligation held_for_too_long(const Subject& s, const Docking& docking, Obligation o);

}  // namespace rtac::verify
