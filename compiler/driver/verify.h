// `rtac verify`: what the decisions of a specification need, and how far it is shown.
#pragma once

#include <iosfwd>

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"

namespace rtac::driver {

// Prints every obligation with its status; writes the certificates where `-o` says. 0: all are
// proved or acknowledged, 3: one is refuted, 4: one is unknown. A specification that is refused
// for what no obligation is about: 1.
int verify(const Options& options, Compilation& c, std::ostream& out);

}  // namespace rtac::driver
