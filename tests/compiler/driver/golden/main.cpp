// rtac_golden [--bless] [CASE...]: compares what the compiler says and writes with the files below
// tests/golden, or makes these files anew. Checking and blessing take the same way; they differ in
// the last step only.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "tests/compiler/driver/golden/case.h"
#include "tests/compiler/driver/golden/diff.h"

namespace {

namespace fs = std::filesystem;
namespace golden = rtac::golden;

constexpr int exit_differs = 1;
constexpr int exit_usage = 2;

// A case is a folder with a specification or a file `args`.
std::vector<std::string> all_cases(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (fs::exists(entry.path() / "spec.rta") || fs::exists(entry.path() / "args")) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Prints what differs; returns the number of files that do.
int compare(const golden::Case& the_case, const golden::Files& actual) {
  const golden::Files expected = golden::read_expected(the_case);
  const std::string prefix = "tests/golden/" + the_case.name + "/expected/";
  int differing = 0;
  for (const auto& [name, text] : actual) {
    const auto known = expected.find(name);
    const std::string shown =
        golden::excerpt(prefix + name, known == expected.end() ? "" : known->second, text);
    if (!shown.empty() || known == expected.end()) {
      std::cout << (known == expected.end() ? "new file\n" : "") << shown << "\n";
      ++differing;
    }
  }
  for (const auto& [name, text] : expected) {
    if (actual.count(name) > 0) continue;
    std::cout << prefix << name << ": is no longer produced\n\n";
    ++differing;
  }
  return differing;
}

int run(bool bless, const fs::path& root, std::vector<std::string> names) {
  const fs::path folder = root / "tests" / "golden";
  const std::vector<std::string> known = all_cases(folder);
  if (names.empty()) names = known;
  std::string failing;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::cerr << "rtac_golden: no case is called `" << name << "`; the cases are the folders of "
                << "tests/golden\n";
      return exit_usage;
    }
    const golden::Case the_case = golden::load_case(root, folder / name);
    const golden::Files actual = golden::run_case(the_case);
    if (compare(the_case, actual) == 0) continue;
    if (bless) {
      golden::write_expected(the_case, actual);
    } else {
      failing += " " + name;
    }
  }
  if (failing.empty()) return 0;
  std::cout << "differs:" << failing << "\nif this is meant: ./dev bless" << failing << "\n";
  return exit_differs;
}

}  // namespace

int main(int argc, char** argv) {
  bool bless = false;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--bless") {
      bless = true;
    } else if (word[0] == '-') {
      std::cerr << "usage: rtac_golden [--bless] [CASE...]\n";
      return exit_usage;
    } else {
      names.push_back(word);
    }
  }
  try {
    return run(bless, fs::path(RTAC_SOURCE_DIR), std::move(names));
  } catch (const std::exception& error) {
    std::cerr << "rtac_golden: " << error.what() << "\n";
    return exit_usage;
  }
}
