#include "compiler/driver/seals.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <sstream>

#include "compiler/driver/files.h"

namespace rtac::driver {
namespace {

struct Seal {
  std::string sum, path;
};
std::vector<Seal> seals_in(const std::string& folder) {
  std::vector<Seal> all;
  std::istringstream lines(read_file(folder + "/" + seals_name).value_or(""));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blank = line.find("  ");
    if (blank != std::string::npos) all.push_back({line.substr(0, blank), line.substr(blank + 2)});
  }
  return all;
}

}  // namespace

std::string sum_of(std::string_view text) {
  std::uint64_t sum = UINT64_C(0xcbf29ce484222325);
  for (const char c : text) {
    sum = (sum ^ static_cast<unsigned char>(c)) * UINT64_C(0x100000001b3);
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(sum));
  return digits;
}

std::string seals_of(std::vector<std::pair<std::string, std::string_view>> files) {
  std::sort(files.begin(), files.end());
  std::string all;
  for (const auto& [path, text] : files) all += sum_of(text) + "  " + path + "\n";
  return all;
}

std::string sealed_anew(const std::string& folder) {
  std::string all;
  for (const Seal& seal : seals_in(folder)) {
    all += sum_of(read_file(folder + "/" + seal.path).value_or("")) + "  " + seal.path + "\n";
  }
  return all;
}

std::vector<std::string> broken_seals(const std::string& folder,
                                      const std::vector<std::string>& read) {
  const std::vector<Seal> seals = seals_in(folder);
  if (seals.empty()) return {seals_name};
  std::vector<std::string> broken;
  for (const Seal& seal : seals) {
    const auto text = read_file(folder + "/" + seal.path);
    if (!text || sum_of(*text) != seal.sum) broken.push_back(seal.path);
  }
  // a line may be taken out of the seals as well as a file is changed
  for (const std::string& path : read) {
    const auto is_it = [&](const Seal& seal) { return seal.path == path; };
    if (std::none_of(seals.begin(), seals.end(), is_it)) broken.push_back(path);
  }
  return broken;
}

}  // namespace rtac::driver
