// The tables that generated code has of a zone, made by the compiler.
#pragma once

#include <memory>

#include "tests/kernel/zones/exact_zone.h"

namespace rtac::kernel_test {

struct FreeTables {
  void operator()(probe_tables* t) const { probe_tables_free(t); }
};
using Tables = std::unique_ptr<probe_tables, FreeTables>;

Tables tables_of(const Zone& zone);

// Queries of the kernel are held against the exact answer within this distance of the boundary;
// beyond it they are lower bounds.
std::int64_t horizon_mm(const Tables& tables);

}  // namespace rtac::kernel_test
