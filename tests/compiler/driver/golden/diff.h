// What differs between two texts, for a person who has to decide whether the change is meant.
#pragma once

#include <string>

namespace rtac::golden {

// Empty when the texts are equal; otherwise an excerpt in the form of a unified diff: the first
// place where they differ, with a few lines around it.
std::string excerpt(const std::string& name, const std::string& expected,
                    const std::string& actual);

}  // namespace rtac::golden
