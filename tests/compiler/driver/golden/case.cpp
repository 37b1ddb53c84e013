#include "tests/compiler/driver/golden/case.h"

#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include "compiler/driver/driver.h"

namespace rtac::golden {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// A directory of its own in the place for temporary files; removed at the end.
class Scratch {
 public:
  Scratch() {
    std::random_device random;
    do {
      path_ = fs::temp_directory_path() / ("rtac_golden_" + std::to_string(random()));
    } while (!fs::create_directory(path_));
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Outcome {
  int status = 0;
  std::string out, err;
};

Outcome run(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  const int status = driver::run(words, out, err);
  return {status, out.str(), err.str()};
}

std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// As a person would see it in a terminal.
std::string transcript(const std::vector<std::string>& words, const Outcome& outcome) {
  std::string text = "$ rtac";
  for (const std::string& word : words) text += " " + word;
  text += "\nexit " + std::to_string(outcome.status) + "\n";
  if (!outcome.out.empty()) text += "--- stdout\n" + outcome.out;
  if (!outcome.err.empty()) text += "--- stderr\n" + outcome.err;
  return text;
}

void add_generated(const Case& the_case, Files& files) {
  const Scratch scratch;
  const std::string directory = (scratch.path() / "out").string();
  const Outcome outcome = run(joined({"build", the_case.spec, "-o", directory}, the_case.flags));
  if (outcome.status != driver::exit_clean) {
    files["build.txt"] = "exit " + std::to_string(outcome.status) + "\n" + outcome.err;
    return;
  }
  for (const auto& entry : fs::directory_iterator(directory)) {
    files["generated/" + entry.path().filename().string()] = read_text(entry.path());
  }
}

}  // namespace

Case load_case(const fs::path& root, const fs::path& folder) {
  Case c;
  c.name = folder.filename().string();
  c.folder = folder;
  c.directory = folder;
  if (fs::exists(folder / "spec.rta")) c.spec = "spec.rta";
  std::ifstream lines(folder / "args");
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream stream(line);
    std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (words.empty() || words[0][0] == '#') continue;
    if (words[0] == "spec" && words.size() == 2) {
      c.spec = words[1];
      c.directory = root;
    } else if (words[0] == "$") {
      c.commands.emplace_back(words.begin() + 1, words.end());
    } else {
      c.flags = joined(std::move(c.flags), words);
    }
  }
  return c;
}

Files run_case(const Case& c) {
  const fs::path before = fs::current_path();
  fs::current_path(c.directory);
  Files files;
  std::string& log = files["transcript.txt"];
  for (const auto& command : c.commands) log += transcript(command, run(command));
  if (c.commands.empty()) {
    const std::vector<std::string> check = joined({"check", c.spec}, c.flags);
    const Outcome outcome = run(check);
    log = transcript(check, outcome);
    if (outcome.status == driver::exit_clean) {
      files["ast.txt"] = run(joined({"check", c.spec, "--dump-ast"}, c.flags)).out;
      files["ir.txt"] = run(joined({"check", c.spec, "--dump-ir"}, c.flags)).out;
      files["expand_lookahead.txt"] =
          run(joined({"check", c.spec, "--print-after", "expand_lookahead"}, c.flags)).out;
      add_generated(c, files);
    }
  }
  fs::current_path(before);
  return files;
}

Files read_expected(const Case& c) {
  Files files;
  const fs::path root = c.folder / "expected";
  if (!fs::exists(root)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), root).generic_string()] = read_text(entry.path());
    }
  }
  return files;
}

void write_expected(const Case& c, const Files& actual) {
  const fs::path root = c.folder / "expected";
  for (const auto& [name, text] : read_expected(c)) {
    if (actual.count(name) == 0) fs::remove(root / name);
  }
  for (const auto& [name, text] : actual) {
    fs::create_directories((root / name).parent_path());
    std::ofstream(root / name, std::ios::binary | std::ios::trunc) << text;
  }
}

}  // namespace rtac::golden
