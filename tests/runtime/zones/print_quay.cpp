// print_quay VERTICES FILE: an outline with islands, as well-known text.
#include <fstream>
#include <string>

#include "tests/bench/zones/outline.h"

int main(int argc, char** argv) {
  using namespace rtac::bench;
  if (argc != 3) return 2;
  std::ofstream out(argv[2]);
  out << well_known_text(outline_of("quay", coast(std::stoul(argv[1]), Vertices::on_grid, 1)));
  return out.good() ? 0 : 1;
}
