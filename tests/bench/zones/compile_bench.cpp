// What it takes from a file with a zone to the object code of its kernel: `rtac build`, and the
// compiler of C.
#include <algorithm>
#include <cstdio>
#include <string>

#include "tests/bench/benchmarks.h"
#include "tests/bench/zones/generated.h"

namespace rtac::bench {
namespace {

struct Shape {
  const char* name;
  Fence (*make)(std::size_t, Vertices, std::uint64_t);
};

bool add_kernel(const Shape& shape, std::size_t vertices, Report& report) {
  const Outline outline = outline_of(shape.name, shape.make(vertices, Vertices::on_grid, 1));
  const std::string what =
      std::string(shape.name) + " of " + std::to_string(vertices) + " vertices";
  const std::string key = std::string(shape.name) + "_" + std::to_string(vertices);
  std::string problem;
  const std::unique_ptr<Generated> g = generate(outline, problem);
  if (!g) {
    std::fprintf(stderr, "rtac_bench: %s: %s\n", what.c_str(), problem.c_str());
    return false;
  }
  report.add("zone_build_" + key, what + ": rtac build", g->rtac.seconds, "s", 2);
  report.add("zone_build_memory_" + key, "  its peak memory", g->rtac.megabytes, "MB", 0);
  report.add("zone_cc_" + key, "  compiling its kernel", g->c_compiler.seconds, "s", 2);
  report.add("zone_tables_" + key, "  tables, all", g->table_bytes / 1024, "KiB", 1);
  report.add("zone_tables_per_vertex_" + key, "  tables, beyond 64 KiB, for each vertex",
             std::max(0.0, g->table_bytes - 65'536) / static_cast<double>(outline.vertices()),
             "bytes", 1);
  return true;
}

}  // namespace

bool measure_zone_kernels(const Effort& effort, Report& report) {
  report.section("Zones: from a file to a kernel");
  std::vector<Shape> shapes{{"coast", coast}, {"circle", circle_fence}, {"star", mild_star}};
  shapes.resize(std::min(shapes.size(), effort.zone_shapes));
  bool good = true;
  for (const Shape& shape : shapes) {
    for (const std::size_t vertices : {10, 100, 1'000, 10'000, 100'000}) {
      good = add_kernel(shape, vertices, report) && good;
    }
  }
  return good;
}

}  // namespace rtac::bench
