// Which attack kills which deliberately unsound decision, with its first seed and how far the
// property was violated.
#include <cstdlib>
#include <iostream>

#include "kills.h"
#include "tests/bench/benchmarks.h"

namespace rtac::bench {

bool measure_kills(const Effort& /*effort*/, Report& report) {
  constexpr int violation = 3, decimals = 4;
  bool all = true;
  report.section("kill table: least margin of the property by the true state");
  for (const campaign::Row& row : campaign::kill_table()) {
    const campaign::Attack a = campaign::attack(row, row.mutant, row.runs);
    if (a.status != violation) {
      std::cerr << row.mutant << " survives:\n" << a.said;
      all = false;
      continue;
    }
    const std::string unit = a.depth.substr(a.depth.find(' ') + 1);
    report.add(std::string("kill_") + row.mutant + "_" + row.spec,
               std::string(row.mutant) + ", " + row.spec + ", " + row.adversary + ", seed " +
                   std::to_string(a.seed),
               std::strtod(a.depth.c_str(), nullptr), unit, decimals);
  }
  return all;
}

}  // namespace rtac::bench
