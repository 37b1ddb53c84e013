// Runs the code that `rtac build` writes: compiled by the system's C compiler into a shared object.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compiler/driver/engine.h"
#include "compiler/driver/files.h"
#include "compiler/support/rational.h"

namespace rtac::driver {

// What the engine has to know of a kernel.
struct KernelInterface {
  std::string prefix;  // of its names
  std::string source;  // name of the .c file
  struct Input {
    std::size_t components;
    bool is_zone;
    std::size_t places_most = 0;  // of a path: way-points
    [[nodiscard]] bool is_path() const { return places_most > 0; }
    // That its sample has.
    [[nodiscard]] std::size_t numbers() const {
      return is_path() ? 2 * places_most : is_zone ? 0 : components;
    }
  };
  std::vector<Input> inputs;
  std::vector<Rational> steps;  // SI in one step of the grid, by component
  // Which component of the specification each of these is, of a path the first of both; empty: they
  // are all of them.
  std::vector<std::size_t> components;
  struct Param {
    Rational step;  // SI in one step of the grid
    std::int64_t value, least, most;
    int tightens;  // the direction; 0: it does not matter
  };
  std::vector<std::size_t> zones;  // those of `components` that are zones: their index in `steps`
  std::vector<Param> params;
  struct Unit {
    std::string text;
    Rational factor;  // from millionths of the scale
  };
  std::vector<Unit> units;  // by index
  std::size_t monitors = 0;
};

struct LoadedKernel {
  std::unique_ptr<Engine> engine;
  std::string problem;   // why there is none
  bool is_ours = false;  // a bug of the compiler, not of the environment
};
// `files`: the kernel's source and header. They live in a temporary folder until this returns.
LoadedKernel load_kernel(const std::vector<OutputFile>& files, const KernelInterface& kernel);

}  // namespace rtac::driver
