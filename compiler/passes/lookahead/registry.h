// The transformers of atoms: what a comparison of signals becomes when it has to hold on everything
// within reach. An atom whose signals have none cannot be looked ahead (5006).
#pragma once

#include <string>

#include "compiler/passes/lookahead/expansion.h"

namespace rtac::passes::lookahead {

// What the transformer of its signals makes of the comparison; 5006 when there is none.
ir::ValueId transform(Expansion& expansion, const Atom& atom);

// What can be looked ahead, as a list in words: "`inside`, `r.battery >= c` and ...".
std::string registered_forms();

}  // namespace rtac::passes::lookahead
