// What exact geometry costs: processor time and memory from the vertices as written to tables on
// the grid, and of erosion. Every case runs in a process of its own, so that the memory is that of
// the case.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <variant>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/fences.h"

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

struct Cost {
  double seconds = 0, megabytes = 0;
};

// What `work` takes, in a child; false: it failed. Time of the processor: the machine may be busy.
template <typename Work>
bool measure(Work work, Cost& cost) {
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) _exit(work() ? 0 : 1);
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) return false;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
  };
  cost.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  cost.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
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

bool measure_zones(Report& report) {
  report.section("Exact geometry");
  using Make = Fence (*)(std::size_t, Vertices, std::uint64_t);
  struct Shape {
    const char* name;
    Make make;
  };
  bool good = true;
  for (const Shape& shape :
       {Shape{"coast", coast}, Shape{"star", noisy_star}, Shape{"comb", comb}}) {
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
  return good;
}

}  // namespace rtac::bench
