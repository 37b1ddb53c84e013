// `rtac sim`: robots under attack, in virtual time.
#pragma once

#include <iosfwd>

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"

namespace rtac::driver {

// Compiles the decisions of the module and starts `rtac-sim`, a program of its own, with them and
// with a manifest of everything else; its output goes to `out`, its exit code is returned.
int simulate(const Options& options, Compilation& c, std::ostream& out);

}  // namespace rtac::driver
