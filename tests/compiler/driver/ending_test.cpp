// A signal to the program ends what it has started and removes what lies about.
#include "compiler/driver/ending.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <set>
#include <thread>

#include "compiler/driver/process.h"
#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

class Endings : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    fs::create_directory("tmp");
    ::setenv("TMPDIR", fs::absolute("tmp").c_str(), 1);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // an orphan comes to us
  }
  void TearDown() override {
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
    ::unsetenv("TMPDIR");
    InFolder::TearDown();
  }
  // A process that runs `script` in a folder of its own; it is running when this returns.
  static pid_t start(const std::string& script) {
    const pid_t pid = ::fork();
    if (pid != 0) {
      for (int k = 0; k < patience && !fs::exists("started"); ++k) rest();
      return pid;
    }
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    {
      const TemporaryFolder folder;
      (void)run_program({"sh", "-c", script + " echo $$ > pid; mv pid started; exec sleep 100"},
                        folder.path() + "/said");
    }
    ::_exit(0);
  }
  static pid_t start_again() {
    fs::remove("started");
    return start("");
  }
  static void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }
  // How it ended; -1: not within two seconds.
  static int end_of(pid_t pid) {
    int status = -1;
    for (int k = 0; k < patience; ++k) {
      if (::waitpid(pid, &status, WNOHANG) == pid) return status;
      rest();
    }
    ::kill(pid, SIGKILL);
    ::waitpid(pid, &status, 0);
    return -1;
  }
  static constexpr int patience = 400;
};

TEST_F(Endings, ASignalEndsTheChildAndRemovesTheFolder) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t pid = start("");
    const pid_t child = std::atoi(read("started").c_str());
    EXPECT_FALSE(fs::is_empty("tmp"));
    ::kill(pid, signal);
    const int status = end_of(pid);
    ASSERT_TRUE(WIFSIGNALED(status)) << signal;
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_NE(::kill(child, 0), 0) << "it is still there";
    EXPECT_TRUE(fs::is_empty("tmp"));
    fs::remove("started");
  }
}

// Who only computes looks for no signal.
TEST_F(Endings, ASignalEndsWhoComputes) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    std::signal(SIGTERM, SIG_DFL);
    const TemporaryFolder folder;
    write("started", "");
    for (volatile bool computes = true; computes;) {
    }
  }
  for (int k = 0; k < patience && !fs::exists("started"); ++k) rest();
  ::kill(pid, SIGTERM);
  int status = 0;
  ::waitpid(pid, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
  EXPECT_FALSE(fs::is_empty("tmp"));
  { const TemporaryFolder next; }
  EXPECT_TRUE(fs::is_empty("tmp"));
}

// Nobody can catch SIGKILL: the next folder of anybody removes what it has left, and nothing else.
TEST_F(Endings, WhatAKilledProgramLeavesIsRemovedByTheNext) {
  const pid_t pid = start("");
  ::kill(pid, SIGKILL);
  (void)end_of(pid);
  ASSERT_FALSE(fs::is_empty("tmp"));
  const pid_t alive = start_again();
  fs::create_directory("tmp/rtac-1-abcdef");          // of a process that lives
  fs::create_directory("tmp/rtac-99999999-abcdefg");  // not one of ours
  fs::create_directory("tmp/rtac-99999999-abcdef");
  fs::create_directory_symlink(fs::absolute("tmp/rtac-1-abcdef"), "tmp/rtac-99999999-ghijkl");
  { const TemporaryFolder next; }
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator("tmp")) left.insert(entry.path().filename());
  const std::string own = "rtac-" + std::to_string(alive) + "-";
  EXPECT_EQ(left.erase("rtac-1-abcdef"), 1U);
  EXPECT_EQ(left.erase("rtac-99999999-abcdefg"), 1U);
  EXPECT_EQ(left.erase("rtac-99999999-ghijkl"), 1U);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_TRUE(left.begin()->starts_with(own)) << *left.begin();
  ::kill(alive, SIGTERM);
  (void)end_of(alive);
}

// Who is no longer there by its number, but holds its lock: in a container that shares the folder.
TEST_F(Endings, AFolderThatIsLockedStays) {
  fs::create_directory("tmp/rtac-99999999-abcdef");
  const int lock = ::open("tmp/rtac-99999999-abcdef", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  { const TemporaryFolder next; }
  EXPECT_TRUE(fs::exists("tmp/rtac-99999999-abcdef"));
  ::close(lock);
  { const TemporaryFolder next; }
  EXPECT_TRUE(fs::is_empty("tmp"));
}

TEST_F(Endings, AChildThatDoesNotListenIsEndedByTheSecondSignal) {
  const pid_t pid = start("trap '' TERM;");
  ::kill(pid, SIGTERM);
  rest();
  EXPECT_EQ(::waitpid(pid, nullptr, WNOHANG), 0);
  ::kill(pid, SIGTERM);
  EXPECT_EQ(WTERMSIG(end_of(pid)), SIGTERM);
  EXPECT_TRUE(fs::is_empty("tmp"));
}

TEST_F(Endings, AChildDiesWithItsParent) {
  const pid_t pid = start("");
  const pid_t child = std::atoi(read("started").c_str());
  ::kill(pid, SIGKILL);
  EXPECT_EQ(WTERMSIG(end_of(pid)), SIGKILL);
  const int status = end_of(child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
}

TEST_F(Endings, WhatTakesTooLongIsEndedWithAllThatItHasStarted) {
  const ProgramResult result =
      run_within(1, {"sh", "-c", "sleep 100 & echo $! > pid; wait"}, "said");
  EXPECT_TRUE(result.started);
  EXPECT_TRUE(result.timed_out);
  const int status = end_of(std::atoi(read("pid").c_str()));
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
  EXPECT_FALSE(run_within(1, {"no-such-program"}, "said").started);
  EXPECT_EQ(run_within(1, {"sh", "-c", "exit 3"}, "said").status, 3);
}

TEST_F(Endings, ASignalEndsWhatTheChildHasStarted) {
  const pid_t pid = start("sleep 100 & echo $! > grandchild;");
  const pid_t grandchild = std::atoi(read("grandchild").c_str());
  ::kill(pid, SIGTERM);
  EXPECT_EQ(WTERMSIG(end_of(pid)), SIGTERM);
  EXPECT_EQ(WTERMSIG(end_of(grandchild)), SIGTERM);
}

TEST_F(Endings, IgnoredSignalsStayIgnored) {
  std::signal(SIGHUP, SIG_IGN);
  {
    const Ending ending;
    ::raise(SIGHUP);
    int status = -1;
    EXPECT_EQ(run_child({"sh", "-c", "kill -HUP $$; exit 7"}, "out", "", status), 0);
    EXPECT_EQ(WEXITSTATUS(status), 7);
  }
  std::signal(SIGHUP, SIG_DFL);
}

TEST_F(Endings, WhatCannotBeStartedIsTold) {
  int status = 0;
  EXPECT_EQ(run_child({"./no_such_program"}, "out", "", status), ENOENT);
  EXPECT_EQ(run_child({"true"}, "no/such/folder", "", status), ENOENT);
}

}  // namespace
}  // namespace rtac::driver::test
