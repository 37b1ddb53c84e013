// Writing all files or none.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rtac::driver {

struct OutputFile {
  std::string path, text;
};

// Creates the directories, writes every file beside its place, then renames all of them. Returns
// what went wrong, empty when all is well; nothing half-written stays behind.
std::string write_all(const std::vector<OutputFile>& files);

// The whole of standard input.
std::string read_stdin();

}  // namespace rtac::driver
