// Controllers: external ones and built-in safe templates.
#pragma once

#include "compiler/sema/context.h"

namespace rtac::sema {

// Needs kinds, sites and zones.
void check_controllers(Context& context);

}  // namespace rtac::sema
