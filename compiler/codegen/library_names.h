// Names that the libraries of C and C++ have taken outside of the text of generated files.
#pragma once

#include <string>

namespace rtac::codegen {

// A function, variable or struct in the global namespace: no namespace may have its name.
bool is_library_global(const std::string& name);

// The header that a generated `STEM.h` would hide from every file beside it, as it is included;
// empty: none. `folder`: last part of the directory of the generated files.
std::string hidden_header(const std::string& stem, const std::string& folder);

}  // namespace rtac::codegen
