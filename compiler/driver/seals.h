// What certificates were when they were written: a sum of each of their files, so that no number of
// them changes by mistake and goes unnoticed. Who forges certificates can seal them anew: what
// they claim is proved once more, whatever their seals say.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rtac::driver {

inline constexpr const char* seals_name = "seals";

// FNV-1a, 16 digits of a hexadecimal number.
std::string sum_of(std::string_view text);

// One line for each file of a folder, its FNV-1a sum and its path below the folder.
std::string seals_of(std::vector<std::pair<std::string, std::string_view>> files);

// The same of the files that the seals of a folder name, as they are now.
std::string sealed_anew(const std::string& folder);

// The files of the folder that are not what was sealed, are missing, or of those that are `read`,
// by their paths below the folder, that nobody sealed; all of it without seals.
std::vector<std::string> broken_seals(const std::string& folder,
                                      const std::vector<std::string>& read);

}  // namespace rtac::driver
