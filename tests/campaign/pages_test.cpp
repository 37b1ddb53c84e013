// What `rtac verify` says of pages that nobody has written holds in the simulator: what it proves
// is not violated, what it refutes with a run is, and its certificates are found to say what it
// says.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "pages.h"
#include "tests/turn.h"

namespace rtac::campaign {
namespace {

namespace fs = std::filesystem;

// Of the program, as users have it (compiler/docs/command.md).
constexpr int clean = 0, errors = 1, refuted = 3, unknown = 4;

// Of so many pages each test looks at those whose turn it is (tests/turn.h): one of them at least,
// where eight take turns, as on the integration machine.
constexpr int pages_each = 8;

class Pages : public ::testing::TestWithParam<int> {
 protected:
  void begin(int seed) {
    home_ = fs::temp_directory_path() / ("rtac_page_" + std::to_string(::getpid()));
    fs::remove_all(home_);
    fs::create_directories(home_);
    page_ = random_page(static_cast<std::uint64_t>(seed));
    write("page.rta", page_);
  }
  void TearDown() override {
    if (!home_.empty()) fs::remove_all(home_);
  }

  void write(const char* name, const std::string& text) const {
    std::ofstream(home_ / name, std::ios::binary) << text;
  }
  // The exit code; what it says goes to said_.
  int rtac(const std::string& words) {
    const std::string command =
        "cd '" + home_.string() + "' && '" + RTAC_PROGRAM + "' " + words + " >said 2>&1";
    const int status = std::system(command.c_str());
    std::ifstream in(home_ / "said");
    said_.assign(std::istreambuf_iterator<char>(in), {});
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::vector<fs::path> runs() const {
    std::vector<fs::path> found;
    for (const auto& each : fs::recursive_directory_iterator(home_)) {
      if (each.path().extension() == ".trace") found.push_back(each.path());
    }
    return found;
  }

  void judge();

  fs::path home_;
  std::string page_, said_;
};

void Pages::judge() {
  SCOPED_TRACE(page_);
  const int verdict = rtac("verify page.rta -o certificates");
  ASSERT_TRUE(verdict == clean || verdict == errors || verdict == refuted || verdict == unknown)
      << verdict << "\n"
      << said_;
  const std::string verified = said_;
  for (const fs::path& run : runs()) {
    EXPECT_EQ(rtac("sim page.rta --replay '" + run.string() + "'"), refuted) << run << said_;
  }
  if (verdict != errors && fs::exists(home_ / "certificates/seals")) {
    EXPECT_EQ(rtac("verify --recheck certificates"), verdict) << verified << said_;
  }
  if (verdict != clean) return;
  // Drawn starts and adversaries in turn, then close to each other, with little charge left.
  EXPECT_EQ(rtac("sim page.rta --runs 60"), clean) << said_;
  write("tight.json", R"({"starts": "tight"})");
  EXPECT_EQ(rtac("sim page.rta --runs 30 --scenario tight.json"), clean) << said_;
}

TEST_P(Pages, HoldWhatIsProvedAndBreakWhatIsRefuted) {
  for (int seed = GetParam(); seed < GetParam() + pages_each; ++seed) {
    if (!test::is_due(static_cast<std::size_t>(seed))) continue;
    begin(seed);
    judge();
    if (HasFailure()) return;
  }
  EXPECT_FALSE(page_.empty()) << "no page had its turn";
}

INSTANTIATE_TEST_SUITE_P(Seeds, Pages, ::testing::Range(1, 41, pages_each));

}  // namespace
}  // namespace rtac::campaign
