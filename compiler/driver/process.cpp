#include "compiler/driver/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

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
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr mode_t for_the_user = 0600;
  constexpr int afresh = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), afresh, for_the_user);
  if (err.empty()) {
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), afresh, for_the_user);
  }
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return {false, 0, std::strerror(error)};

  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return {false, 0, std::strerror(errno)};
  }
  return {true, WIFEXITED(status) ? WEXITSTATUS(status) : -1, ""};
}

}  // namespace rtac::driver
