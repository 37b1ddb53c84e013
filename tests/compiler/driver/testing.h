// Runs the command line in process, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/driver/driver.h"
#include "compiler/driver/seals.h"

namespace rtac::driver::test {

namespace fs = std::filesystem;

struct Outcome {
  int status = 0;
  std::string out, err;
};

inline Outcome rtac(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  const int status = run(words, out, err);
  return {status, out.str(), err.str()};
}

inline std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

inline void write(const fs::path& path, const std::string& text) {
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

// What certificates claim is looked at by itself: whatever a test has changed is sealed once more.
inline Outcome recheck_sealed_anew(const std::string& folder = "certificates") {
  write(folder + "/" + seals_name, sealed_anew(folder));
  return rtac({"verify", "--recheck", folder});
}

inline std::string spec_text(const std::string& path) {
  return read(fs::path(RTAC_SOURCE_DIR) / path);
}

// A specification of one file: the drone of the golden cases with a fence.
inline std::string drone_spec() {
  return "spec fence_study;\n" + spec_text("tests/golden/parts/drone.rta") + R"(
monitor walls for d : Drone {
  "SR-1: the drone stays clear of the walls"
  always  clearance(d, room) >= 10 cm;
  ahead   100 ms, 2 waypoints;
  recover back_off;
}
decision fly for Drone { advanced pilot; period 50 ms; priority walls; }
)";
}

// Replaces the first place of `from`; a test whose text is not there must fail.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    ADD_FAILURE() << "not in the text: " << from;
    return text;
  }
  return text.replace(at, from.size(), to);
}

// Tests run in a folder of their own, which is the current one meanwhile.
class InFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    before_ = fs::current_path();
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("rtac_") + info->test_suite_name() + "_" + info->name() + "_" +
                       std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = fs::temp_directory_path() / name;
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }
  // All files below the folder, sorted, as relative paths.
  static std::vector<std::string> listing() {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(".")) {
      if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), ".").generic_string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  fs::path folder_;

 private:
  fs::path before_;
};

}  // namespace rtac::driver::test
