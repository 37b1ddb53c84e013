#include "compiler/driver/process.h"

#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace rtac::driver {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const auto base = std::filesystem::temp_directory_path(error);
  if (error) {
    problem_ = "there is no folder for temporary files: " + error.message();
    return;
  }
  std::string name = (base / "rtac-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    problem_ = "cannot create a folder in `" + base.string() + "`: " + std::strerror(errno);
  } else {
    path_ = name;
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

ProgramResult run_program(const std::vector<std::string>& words, const std::string& log) {
  return run_program(words, log, "");
}

ProgramResult run_program(const std::vector<std::string>& words, const std::string& out,
                          const std::string& err) {
  int status = 0;
  if (const int error = run_child(words, out, err, status); error != 0) {
    return {false, 0, std::strerror(error)};
  }
  return {true, WIFEXITED(status) ? WEXITSTATUS(status) : -1, ""};
}

}  // namespace rtac::driver
