// The function of a monitor without a robot that tells its verdict alone.
//
// A condition is printed as two, whether it surely holds and whether it may: each comparison is one
// between bounds. What is used more than once, or by an operator that remembers, has a name and is
// kept in two bits. A quantity that has no form of its own here is computed as for margins.
#pragma once

#include <set>
#include <string>

#include "compiler/codegen/code.h"
#include "compiler/codegen/repeat_printer.h"
#include "compiler/codegen/watch.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

// What a function about the view `v` consists of. `verdict`: prefix of the names of verdicts.
// `uses` collects library functions.
struct VerdictBody {
  Code lines;
  bool looks = false;  // at the view at all
};
VerdictBody verdict_body(const WatchKernel& kernel, const WatchNames& names, const ir::Block& block,
                         const std::string& verdict, std::set<std::string>& uses,
                         RepeatPrinter* repeats = nullptr);
// The values of what is repeated behind its arguments; returns bits, or bounds.
VerdictBody repeated_bits(const WatchKernel& kernel, const WatchNames& names,
                          const Repeated& repeated, std::set<std::string>& uses);

}  // namespace rtac::codegen
