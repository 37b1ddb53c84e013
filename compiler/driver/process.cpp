#include "compiler/driver/process.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "compiler/diagnostics/characters.h"

namespace rtac::driver {
namespace {

namespace fs = std::filesystem;

constexpr int letters = 6;  // that `mkdtemp` makes up
constexpr std::string_view prefix = "rtac-";

// A lock on the folder itself, as long as the descriptor is open; -1: there is none. It ends with
// the process, however that ends, and holds between containers that share the folder.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

// The process that a folder is named after: rtac-PID-XXXXXX; 0: it is no such folder.
pid_t maker_of(const std::string& name) {
  if (!name.starts_with(prefix)) return 0;
  const std::size_t end = name.find('-', prefix.size());
  if (end == std::string::npos || name.size() != end + 1 + letters) return 0;
  long pid = 0;
  for (std::size_t i = prefix.size(); i < end; ++i) {
    if (std::isdigit(static_cast<unsigned char>(name[i])) == 0 || pid > 100'000'000) return 0;
    pid = 10 * pid + (name[i] - '0');
  }
  return static_cast<pid_t>(pid);
}

// What processes have left behind that were killed before they could remove it: those that are gone
// and hold no lock, of this user.
void sweep(const fs::path& base) {
  std::error_code error;
  for (fs::directory_iterator at(base, error), end; !error && at != end; at.increment(error)) {
    const pid_t maker = maker_of(at->path().filename().string());
    if (maker <= 0 || ::kill(maker, 0) == 0 || errno != ESRCH) continue;
    struct stat found {};
    if (::lstat(at->path().c_str(), &found) != 0 || found.st_uid != ::geteuid()) continue;
    const int lock = locked(at->path());
    if (lock < 0) continue;
    std::error_code ignored;
    fs::remove_all(at->path(), ignored);
    ::close(lock);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const auto base = fs::temp_directory_path(error);
  if (error) {
    problem_ = "there is no folder for temporary files: " + error.message();
    return;
  }
  sweep(base);
  std::string name = (base / "rtac.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    problem_ = "cannot create a folder in `" + base.string() + "`: " + std::strerror(errno);
    return;
  }
  // it gets the name that others sweep when it is locked
  lock_ = locked(name);
  path_ = name;
  const fs::path own = base / (std::string(prefix) + std::to_string(::getpid()) + "-" +
                               name.substr(name.size() - letters));
  fs::rename(name, own, error);
  if (!error) path_ = own.string();
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

ProgramResult run_program(const std::vector<std::string>& words, const std::string& log) {
  return run_program(words, log, "");
}

ProgramResult run_program(const std::vector<std::string>& words, const std::string& out,
                          const std::string& err) {
  int status = 0;
  if (const int error = run_child(words, out, err, status); error != 0) {
    return {false, false, 0, std::strerror(error)};
  }
  constexpr int signalled = 128;  // as shells say it
  const int ended = WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
  return {true, false, ended, ""};
}

ProgramResult run_within(int seconds, std::vector<std::string> words, const std::string& log) {
  using std::chrono::steady_clock;
  constexpr int no_such_program = 127, too_long = 124, killed = 128 + SIGKILL;  // of coreutils
  const std::string program = words.front();
  words.insert(words.begin(), {"timeout", "--kill-after=2", std::to_string(seconds)});
  const auto deadline = steady_clock::now() + std::chrono::seconds(seconds);
  ProgramResult result = run_program(words, log);
  if (!result.started) {
    result.problem = no_timeout;
    return result;
  }
  if (result.status == no_such_program) {
    return {false, false, 0, "no program is called `" + program + "`"};
  }
  // else somebody else has killed it, for want of memory for example
  const bool by_timeout = result.status == killed && steady_clock::now() >= deadline;
  result.timed_out = result.status == too_long || by_timeout;
  return result;
}

double core_seconds_of_children() {
  constexpr double s_per_us = 1e-6;
  struct rusage used {};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + s_per_us * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::string told(const std::string& written) {
  constexpr std::size_t longest = 120;  // bytes, before they are made printable
  constexpr const char* blanks = " \t\r\n";
  const std::size_t from = written.find_first_not_of(blanks);
  if (from == std::string::npos) return "it says nothing";
  const std::size_t end = std::min(written.find('\n', from), written.size());
  std::string line = written.substr(from, std::min(end - from, longest));
  line.erase(line.find_last_not_of(blanks) + 1);
  return diag::printable(line) + (end - from > longest ? "..." : "");
}

}  // namespace rtac::driver
