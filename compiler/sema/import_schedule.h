// From the schedule of an area of a file to the windows of time of a zone.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "compiler/geometry/import/areas.h"
#include "compiler/sema/context.h"

namespace rtac::sema {

// Most windows of a zone of a file, a day of a week counting as one: what applies every day between
// two dates has one for each of them, and a year of days fits.
inline constexpr std::size_t max_scheduled = 512;

// Exactly the moments of the schedule, in order; or why there are no such windows, with the period
// in the file. Bounded time for any schedule.
std::variant<std::vector<Opening>, geometry::import::Failure> openings_of(
    const std::vector<geometry::import::Period>& schedule);

// "monday 08:00:00 .. 12:00:00, and 3 more windows".
std::string summary_of(const std::vector<Opening>& openings);

// The word of an import that takes the schedule of its file; nullptr: another expression, or none.
const syntax::ImportOption* scheduled_in(const syntax::Expr& expr);

}  // namespace rtac::sema
