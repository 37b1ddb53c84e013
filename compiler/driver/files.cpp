#include "compiler/driver/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "compiler/support/source.h"

namespace rtac::driver {
namespace {

namespace fs = std::filesystem;

// Removes what was written beside its place unless everything was renamed.
class Staging {
 public:
  ~Staging() {
    std::error_code ignored;
    for (const auto& [temporary, target] : staged_) fs::remove(temporary, ignored);
    // which is for those that are empty
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
      fs::remove(*folder, ignored);
    }
  }
  std::string write(const fs::path& target, const std::string& text) {
    std::error_code error;
    const fs::path directory = target.parent_path();
    if (!directory.empty() && !fs::is_directory(directory, error)) {
      std::vector<fs::path> missing;
      for (fs::path at = directory; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
        missing.push_back(at);
      }
      made_.insert(made_.end(), missing.rbegin(), missing.rend());
      fs::create_directories(directory, error);
      if (error) {
        return "cannot create the directory `" + directory.string() + "`: " + error.message();
      }
    }
    if (fs::is_directory(target, error)) return "`" + target.string() + "` is a directory";
    const fs::path place = resolved(target);
    if (is_special(place)) {
      special_.emplace_back(place, text);
      return "";
    }
    fs::path temporary = place;
    temporary += ".rtac-new";
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (out) staged_.emplace_back(temporary, place);
    out << text;
    out.close();
    if (!out) return "cannot write `" + target.string() + "`: " + std::strerror(errno);
    return "";
  }
  // Devices come first: they may be full, renaming hardly fails any more.
  std::string commit() {
    for (const auto& [target, text] : special_) {
      std::ofstream out(target, std::ios::binary);
      out << text;
      out.close();
      if (!out) return "cannot write `" + target.string() + "`: " + std::strerror(errno);
    }
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
  // Renaming onto a symbolic link would replace the link, not what it leads to.
  static fs::path resolved(fs::path target) {
    constexpr int links_max = 40;  // as the kernel's limit; a circle is reported by the write
    std::error_code error;
    for (int i = 0; i < links_max && fs::is_symlink(target, error); ++i) {
      target = target.parent_path() / fs::read_symlink(target, error);
    }
    return target;
  }
  // Renaming onto a device would replace it: `--depfile /dev/null` as root.
  static bool is_special(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  }

  std::vector<std::pair<fs::path, std::string>> special_;
  std::vector<std::pair<fs::path, fs::path>> staged_;
  std::vector<fs::path> made_;  // folders, from the outside inwards
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

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::path first = fs::weakly_canonical(a, error);
  const fs::path second = error ? fs::path{} : fs::weakly_canonical(b, error);
  return error ? a == b : first == second;
}

std::string last_folder(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(path, error);
  const fs::path& known = error ? fs::path(path) : whole;
  return (known.has_filename() ? known : known.parent_path()).filename().string();
}

// Not std::cin, which takes a closed descriptor for an empty file.
std::optional<std::string> read_file(const std::string& path) {
  std::string why;
  return rtac::read_file(path, why);
}

std::optional<std::string> read_stdin(std::string& why) {
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, block.data(), block.size());
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      why = std::strerror(errno);
      return std::nullopt;
    }
    text.append(block.data(), static_cast<std::size_t>(count));
    if (text.size() > SourceManager::file_bytes_max) {
      why = "it is larger than 64 MiB";
      return std::nullopt;
    }
  }
}

}  // namespace rtac::driver
