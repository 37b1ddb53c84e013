// What stands in acsl/*.acsl, in the order in which it is read.
#pragma once

#include <vector>

namespace rtac::contract {

const std::vector<const char*>& library_texts();

}  // namespace rtac::contract
