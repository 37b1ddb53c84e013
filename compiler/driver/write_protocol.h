// `rtac protocol`: the switching protocol of every decision as a model in Promela.
#pragma once

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"

namespace rtac::driver {

// Writes DIR/<decision>.pml, all of them or none; the exit code.
int write_protocol(const Options& options, Compilation& c);

}  // namespace rtac::driver
