// Without GEOS, its rows are missing.
#include "tests/bench/zones/contender.h"

namespace rtac::bench {

std::vector<Contender> geos_contenders(Question, const Outline&, const std::vector<GridPlace>&) {
  return {};
}

}  // namespace rtac::bench
