// Runs an example with a list of flags and reads the results that it writes.
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace study {

inline nlohmann::json run(const std::string& flags, const std::string& name) {
  const std::string file = (std::filesystem::temp_directory_path() /
                            ("rtac_study_" + name + "_" + std::to_string(::getpid()) + ".json"))
                               .string();
  const std::string command =
      std::string("\"") + STUDY + "\" " + flags + " --json \"" + file + "\" > /dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(status, 0) << command;
  std::ifstream in(file);
  nlohmann::json results = nlohmann::json::parse(in, nullptr, false);
  std::filesystem::remove(file);
  EXPECT_FALSE(results.is_discarded()) << command;
  return results;
}

}  // namespace study
