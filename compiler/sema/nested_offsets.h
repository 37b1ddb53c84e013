// How deep `grow` and `shrink` lie within one another, in one zone or by way of names.
#pragma once

#include <cstddef>
#include <map>

#include "compiler/sema/spec.h"

namespace rtac::sema {

class NestedOffsets {
 public:
  // The specification has no errors, and outlives this.
  explicit NestedOffsets(const Spec& spec);
  // Of those that this one lies in, or that lie in it, the most that lie within one another, itself
  // among them.
  [[nodiscard]] std::size_t with(const ZoneOffset& offset) const { return most_.at(&offset); }

 private:
  std::size_t within(const ZoneExpr& expr);
  void count(const ZoneExpr& expr, std::size_t around);

  const Spec& spec_;
  std::map<const ZoneExpr*, std::size_t> within_, around_;
  std::map<const ZoneOffset*, std::size_t> most_;
};

}  // namespace rtac::sema
