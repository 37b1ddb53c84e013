// Types as written: `real [m/s]`, `Gear`, `point[4]`.
#pragma once

#include <optional>

#include "compiler/sema/context.h"

namespace rtac::sema {

// Most elements of an array.
inline constexpr int max_array = 4096;
// Most edges of a zone that is received while the monitors run.
inline constexpr int max_zone_edges = 100'000;

enum class MayBeZone { no, yes };

// nullopt: a mistake, which was reported.
std::optional<ValueType> check_type(Context& context, const syntax::TypeRef& written,
                                    MayBeZone may_be_zone = MayBeZone::no);

}  // namespace rtac::sema
