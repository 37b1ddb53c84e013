#include "compiler/driver/ending.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>

namespace rtac::driver {
namespace {

constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};

constexpr unsigned grace_s = 2;

volatile std::sig_atomic_t signal_seen = 0;
volatile pid_t child = 0;  // changed only while the signals wait
int endings = 0;
std::array<struct sigaction, signals.size()> before;

void end_child(int signal) {
  const int error = errno;
  // Whoever does not listen the first time is not asked again; with all that it has started.
  if (child > 0) ::kill(-child, signal_seen == 0 ? signal : SIGKILL);
  if (child <= 0) ::alarm(grace_s);
  signal_seen = signal;
  errno = error;
}
// Nobody looks whether a signal has been seen while something is computed.
void end_now(int /*signal*/) {
  std::signal(signal_seen, SIG_DFL);
  ::raise(signal_seen);
}

// No signal is handled as long as it lives.
class Quiet {
 public:
  Quiet() {
    sigset_t all;
    sigemptyset(&all);
    for (const int signal : signals) sigaddset(&all, signal);
    ::sigprocmask(SIG_BLOCK, &all, &mask_);
  }
  ~Quiet() { end(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  void end() const { ::sigprocmask(SIG_SETMASK, &mask_, nullptr); }

 private:
  sigset_t mask_{};
};

bool take(int descriptor, const std::string& path) {
  constexpr mode_t for_the_user = 0600;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, for_the_user);
  return file >= 0 && ::dup2(file, descriptor) >= 0;
}
bool take_streams(const std::string& out, const std::string& err) {
  if (!take(STDOUT_FILENO, out)) return false;
  return err.empty() ? ::dup2(STDOUT_FILENO, STDERR_FILENO) >= 0 : take(STDERR_FILENO, err);
}

// In the child, after fork. What it cannot do is told through `report`, which closes by itself.
[[noreturn]] void become(std::vector<char*>& arguments, const std::string& out,
                         const std::string& err, pid_t parent, const Quiet& quiet, int report) {
  for (const int signal : signals) {
    struct sigaction now {};
    ::sigaction(signal, nullptr, &now);
    if (now.sa_handler == end_child) std::signal(signal, SIG_DFL);
  }
  ::setpgid(0, 0);
  quiet.end();
  // It may have died already, before it was asked for.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() == parent && take_streams(out, err)) ::execvp(arguments[0], arguments.data());
  const int error = errno;
  [[maybe_unused]] const ssize_t told = ::write(report, &error, sizeof error);
  constexpr int not_started = 127;
  ::_exit(not_started);
}

// Reaps it, and sends nothing to a number that may be somebody else's by then.
int wait_for_child() {
  siginfo_t ended;
  while (::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 &&
         errno == EINTR) {
  }
  const Quiet quiet;
  ::kill(-child, SIGKILL);  // what it has started, and what has not listened to it
  int status = 0;
  ::waitpid(child, &status, 0);
  child = 0;
  return status;
}

}  // namespace

Ending::Ending() {
  if (endings++ > 0) return;
  signal_seen = 0;
  std::signal(SIGALRM, end_now);
  for (std::size_t k = 0; k < signals.size(); ++k) {
    ::sigaction(signals[k], nullptr, &before[k]);
    if (before[k].sa_handler == SIG_IGN) continue;
    struct sigaction ours {};
    ours.sa_handler = end_child;  // and waiting is interrupted
    ::sigaction(signals[k], &ours, nullptr);
  }
}

Ending::~Ending() {
  if (--endings > 0) return;
  ::alarm(0);
  std::signal(SIGALRM, SIG_DFL);
  for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &before[k], nullptr);
  if (signal_seen != 0) ::raise(signal_seen);
}

int run_child(const std::vector<std::string>& words, const std::string& out, const std::string& err,
              int& status) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> report{};
  if (::pipe2(report.data(), O_CLOEXEC) != 0) return errno;
  const pid_t parent = ::getpid();
  {
    const Quiet quiet;
    const pid_t pid = ::fork();
    if (pid == 0) become(arguments, out, err, parent, quiet, report[1]);
    const int error = errno;
    ::close(report[1]);
    if (pid < 0) {
      ::close(report[0]);
      return error;
    }
    ::setpgid(pid, pid);  // whichever of the two comes first
    child = pid;
    if (signal_seen != 0) ::kill(-pid, SIGKILL);  // it came just before
  }
  int error = 0;
  ssize_t told = 0;
  while ((told = ::read(report[0], &error, sizeof error)) < 0 && errno == EINTR) {
  }
  ::close(report[0]);
  status = wait_for_child();
  return told == static_cast<ssize_t>(sizeof error) ? error : 0;
}

}  // namespace rtac::driver
