// Writing all files or none.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtac::driver {

struct OutputFile {
  std::string path, text;
};

// Creates the directories, writes every file beside its place, then renames all of them. Returns
// what went wrong, empty when all is well; nothing half-written stays behind. A device or a pipe is
// written to, never replaced by a file of its name.
std::string write_all(const std::vector<OutputFile>& files);

// Two paths of one file, which need not exist.
bool same_file(const std::string& a, const std::string& b);

// The name of the directory itself: `out` of `build/out/`.
std::string last_folder(const std::string& path);

// The whole of a file; nullopt when it cannot be read.
std::optional<std::string> read_file(const std::string& path);

// The whole of standard input; nullopt when it is closed or cannot be read: `why` receives the
// system's reason.
std::optional<std::string> read_stdin(std::string& why);

}  // namespace rtac::driver
