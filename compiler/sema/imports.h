// Zones that are read from files: what the author says about the file and what the file says are
// brought together; nothing is guessed.
#pragma once

#include <optional>

#include "compiler/sema/context.h"

namespace rtac::sema {

// `frame`: of the zone. nullopt: reported.
std::optional<ZoneImport> import_zone(Context& context, const syntax::ImportLit& written,
                                      FrameId frame);

}  // namespace rtac::sema
