// What exact geometry costs: processor time and memory from the vertices as written to tables on
// the grid, and of erosion.
#include <algorithm>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/fences.h"
#include "tests/bench/zones/cost.h"

namespace rtac::bench {
namespace {

using geometry::Region;

// Validated, then snapped as a keep-in and as a keep-out, each verified exactly.
bool prepare(const Fence& fence) {
  const auto result = Region::polygon(fence.outer, fence.holes);
  const auto* region = std::get_if<Region>(&result);
  return region != nullptr && geometry::snap_inside(*region) && geometry::snap_around(*region);
}

bool erode(const Fence& fence, const Rational& distance_m) {
  const auto result = Region::polygon(fence.outer, fence.holes);
  const auto* region = std::get_if<Region>(&result);
  return region != nullptr && region->contains(region->shrink(distance_m));
}

template <typename Work>
bool add(Report& report, const std::string& key, const std::string& what, Work work) {
  Cost cost;
  if (!measure(work, cost)) {
    std::fprintf(stderr, "rtac_bench: %s failed\n", what.c_str());
    return false;
  }
  report.add("seconds_" + key, what, cost.seconds, "s", 3);
  report.add("memory_" + key, what + ": peak memory", cost.megabytes, "MB", 0);
  return true;
}

}  // namespace

bool measure_geometry(const Effort& effort, Report& report) {
  report.section("Exact geometry");
  using Make = Fence (*)(std::size_t, Vertices, std::uint64_t);
  struct Shape {
    const char* name;
    Make make;
  };
  bool good = true;
  std::vector<Shape> shapes{{"coast", coast}, {"star", noisy_star}, {"comb", comb}};
  shapes.resize(std::min(shapes.size(), effort.zone_shapes));
  for (const Shape& shape : shapes) {
    const std::string name = shape.name;
    for (const std::size_t vertices : {1'000, 10'000, 100'000}) {
      const std::string count = std::to_string(vertices);
      const Fence fence = shape.make(vertices, Vertices::off_grid, 1);
      good = add(report, "zone_" + name + "_" + count, name + " of " + count + " vertices",
                 [&] { return prepare(fence); }) &&
             good;
    }
    const Fence fence = shape.make(10'000, Vertices::off_grid, 1);
    for (const int distance_m : {1, 20}) {
      const std::string metres = std::to_string(distance_m);
      good = add(report, "erosion_" + name + "_" + metres,
                 name + " of 10000 vertices, shrunk by " + metres + " m",
                 [&] { return erode(fence, distance_m); }) &&
             good;
    }
  }
  return measure_zone_kernels(effort, report) && good;
}

}  // namespace rtac::bench
