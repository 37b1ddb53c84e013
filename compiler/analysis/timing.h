// When things happen in a decision: how far its monitors look ahead, and how late its steps may be.
#pragma once

#include <cstdint>

#include "compiler/sema/spec.h"

namespace rtac::analysis {

// theory, horizon: a template is computed every tick and issued in the failing one (k = 1); an
// external recovery is asynchronous (k = 2).
std::int64_t periods_of(const sema::Spec& spec, const sema::Monitor& monitor);
// As declared, or the least that works.
std::int64_t lookahead_us(const sema::Spec& spec, const sema::Monitor& monitor,
                          std::int64_t period_us);
// As declared; or else, where a look-ahead leaves no room for it, a part of the period. None of
// them is longer than `lookahead_most_us`.
std::int64_t jitter_us(const sema::Spec& spec, const sema::Decision& decision,
                       std::int64_t period_us, std::int64_t lookahead_most_us = INT64_MAX);
// How much further than the check the return condition looks.
std::int64_t return_extra_us(const sema::Spec& spec, const sema::Decision& decision,
                             std::int64_t period_us);

}  // namespace rtac::analysis
