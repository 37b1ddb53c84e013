// Monitors: requirement, property, look-ahead, recovery, condition of return.
#pragma once

#include "compiler/sema/context.h"

namespace rtac::sema {

// Needs everything but the decisions.
void check_monitors(Context& context);

// The look-ahead that the terms of a monitor say; see lookahead.cpp.
Ahead check_ahead(Context& context, const syntax::MonitorItem& monitor,
                  const std::optional<KindId>& kind);

}  // namespace rtac::sema
