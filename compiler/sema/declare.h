// The first step: every declaration gets its name and its id.
#pragma once

#include "compiler/sema/context.h"

namespace rtac::sema {

void declare_all(Context& context, const syntax::Program& program);

}  // namespace rtac::sema
