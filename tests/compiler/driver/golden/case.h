// One golden case: a folder with a specification (or the name of one), run through the command
// line of the compiler in process. See tests/golden/README.md for the form of a case.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rtac::golden {

// Path below `expected/` -> text.
using Files = std::map<std::string, std::string>;

struct Case {
  std::string name;
  std::filesystem::path folder;
  std::filesystem::path directory;  // where the commands run
  std::string spec;                 // as seen from there; empty: only the commands of `args`
  std::vector<std::string> flags;   // added to every command
  std::vector<std::vector<std::string>> commands;
};

// `root`: of the repository. `folder`: of the case.
Case load_case(const std::filesystem::path& root, const std::filesystem::path& folder);

// Everything that the compiler says and writes.
Files run_case(const Case& the_case);

Files read_expected(const Case& the_case);
// Rewrites `expected/`, and removes from it what is no longer produced.
void write_expected(const Case& the_case, const Files& actual);

}  // namespace rtac::golden
