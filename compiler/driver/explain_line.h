// `rtac explain FILE:LINE`: what was derived for a line of a specification.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"
#include "compiler/support/source.h"

namespace rtac::driver {

// What is known about a piece of source text: a line about it, and details below.
struct Remark {
  SourceRange source;
  std::string text;
  std::vector<std::string> details;
};

// Of what belongs to no robot: period, inputs, parameters, every expression of every monitor.
std::vector<Remark> watch_remarks(const Compilation& c);
// Of the origin of the map and of zones that are read from files.
std::vector<Remark> import_remarks(const Compilation& c);
// Of robots without a decision, and of zones that are there at certain times.
std::vector<Remark> declared_remarks(const Compilation& c);
// Of robots, zones, controllers, monitors and decisions.
std::vector<Remark> robot_remarks(const Compilation& c);

// Prints what touches the line to `out`; what is wrong goes to the diagnostics of `c`. The result
// is the exit code.
int explain_line(const Options& options, Compilation& c, std::ostream& out);

}  // namespace rtac::driver
