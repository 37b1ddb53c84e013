// The library of the kernel: C functions whose text stands in kernel/*.c. A function starts at a
// line `/*= name : needs needs */`; only what a specification needs is printed. A line that begins
// with `/*? name */` is part of its function only when `name` is needed too. Zones come in two
// kinds: functions marked `@cells` after their name are there when `cells` is wanted, those marked
// `@edges` when it is not; and so do distances between robots, by `@in_space` and `@plane`, and
// those from agents.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace rtac::codegen {

// The embedded files, in the order in which they are printed.
const std::vector<const char*>& kernel_texts();

// The text of the wanted functions and of everything that they need, in library order, with
// `KERNEL_` and the prefixes of the enumerations replaced by `prefix_` (`PREFIX_`).
// Types of the state (`NAME_state`) are left out: the header declares them.
std::string kernel_library(const std::set<std::string>& wanted, const std::string& prefix);
// The text of the wanted types of the state and of those that they hold.
std::string kernel_types(const std::set<std::string>& wanted, const std::string& prefix);

}  // namespace rtac::codegen
