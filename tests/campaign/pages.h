// Whole specifications that nobody has written: zones, a robot, monitors, recoveries and their
// order are drawn from a seed.
#pragma once

#include <cstdint>
#include <string>

namespace rtac::campaign {

// The same page of text for the same seed, on every machine. Most pages pass `rtac check`.
std::string random_page(std::uint64_t seed);

}  // namespace rtac::campaign
