// When a zone is there: windows of time, as written and as numbers.
#pragma once

#include <string>
#include <vector>

#include "compiler/sema/context.h"

namespace rtac::sema {

// Windows without mistakes; the others are reported.
std::vector<Opening> check_openings(Context& context, const std::vector<syntax::Opening>& written);

// "2026-05-01T08:00:00Z .. 2026-05-01T18:00:00Z", ".. 2026-05-01T08:00:00Z" without a first moment,
// "monday, friday 07:30:00 .. 16:00:00".
std::string text_of(const Opening& opening);

// Whether all zones with windows that these speak of are gone at once from some moment on, for so
// long: after one of the windows has ended, or in a week before or after all that have dates.
// false: no such moment was found.
bool are_ever_gone(const Spec& spec, const std::vector<const Expr*>& speaking,
                   std::int64_t lasting_s);

// Most windows of one zone: they become a table, which is looked up in every tick.
inline constexpr std::size_t max_openings = 64;

}  // namespace rtac::sema
