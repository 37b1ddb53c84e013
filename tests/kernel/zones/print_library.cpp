// print_library FILE: the part of the kernel's library that the tests of zones call.
#include <fstream>

#include "compiler/codegen/kernel_library.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ofstream out(argv[1]);
  out << rtac::codegen::kernel_library(
      {"inside_zone", "boundary_gap_lo", "segment_boundary_lo", "place_of", "box_in_zone",
       "middle_clearance", "plan_in_zone", "zone_reach", "verdict_of"},
      "probe");
  return out.good() ? 0 : 1;
}
