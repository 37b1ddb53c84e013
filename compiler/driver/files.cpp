#include "compiler/driver/files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace rtac::driver {
namespace {

namespace fs = std::filesystem;

// Removes what was written beside its place unless everything was renamed.
class Staging {
 public:
  ~Staging() {
    std::error_code ignored;
    for (const auto& [temporary, target] : staged_) fs::remove(temporary, ignored);
  }
  std::string write(const fs::path& target, const std::string& text) {
    std::error_code error;
    const fs::path directory = target.parent_path();
    if (!directory.empty() && !fs::is_directory(directory, error)) {
      fs::create_directories(directory, error);
      if (error) {
        return "cannot create the directory `" + directory.string() + "`: " + error.message();
      }
    }
    if (fs::is_directory(target, error)) return "`" + target.string() + "` is a directory";
    fs::path temporary = target;
    temporary += ".rtac-new";
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (out) staged_.emplace_back(temporary, target);
    out << text;
    out.close();
    if (!out) return "cannot write `" + target.string() + "`: " + std::strerror(errno);
    return "";
  }
  std::string commit() {
    while (!staged_.empty()) {
      std::error_code error;
      fs::rename(staged_.back().first, staged_.back().second, error);
      if (error) {
        return "cannot write `" + staged_.back().second.string() + "`: " + error.message();
      }
      staged_.pop_back();
    }
    return "";
  }

 private:
  std::vector<std::pair<fs::path, fs::path>> staged_;
};

}  // namespace

std::string write_all(const std::vector<OutputFile>& files) {
  Staging staging;
  for (const OutputFile& file : files) {
    if (std::string problem = staging.write(file.path, file.text); !problem.empty()) {
      return problem;
    }
  }
  return staging.commit();
}

std::string read_stdin() {
  return std::string(std::istreambuf_iterator<char>(std::cin), {});
}

}  // namespace rtac::driver
