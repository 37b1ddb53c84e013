// The tables that generated code has of a zone, made by the compiler.
#pragma once

#include <memory>
#include <variant>

#include "compiler/geometry/cell_tree.h"
#include "tests/kernel/zones/exact_zone.h"

namespace rtac::kernel_test {

struct FreeTables {
  void operator()(probe_tables* t) const { probe_tables_free(t); }
};
using Tables = std::unique_ptr<probe_tables, FreeTables>;

struct Tabled {
  Tables tables;            // nullptr: the compiler refuses, and `dense` says why
  std::int64_t horizon_mm;  // distances up to this one are close to exact, longer ones bounds
  std::size_t bytes;
  std::int32_t edges_most;  // that are looked at for a place
  geometry::TooDense dense;
};
Tabled table(const Zone& zone);
// Of one that is not refused.
Tables tables_of(const Zone& zone);

}  // namespace rtac::kernel_test
