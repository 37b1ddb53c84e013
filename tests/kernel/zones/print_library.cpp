// print_library edges|cells FILE: the part of the kernel's library that the tests of zones call,
// for zones of few edges or of many.
#include <fstream>
#include <set>
#include <string>

#include "compiler/codegen/kernel_library.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::set<std::string> wanted{"inside_zone",  "boundary_gap_lo", "segment_boundary_lo",
                               "place_of",     "box_in_zone",     "middle_clearance",
                               "plan_in_zone", "zone_reach",      "verdict_of",
                               "leave_mm",     "leave_disc_mm",   "border_of"};
  wanted.insert(argv[1]);
  std::ofstream out(argv[2]);
  out << rtac::codegen::kernel_library(wanted, "probe");
  return out.good() ? 0 : 1;
}
