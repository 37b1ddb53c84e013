// `rtac verify` of a specification in a folder of its own.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {

using Json = nlohmann::json;

class Verify : public InFolder {
 protected:
  // Nothing is shown by runs, whichever tests came before, unless a test says where `rtac-sim` is.
  void SetUp() override {
    InFolder::SetUp();
    ::unsetenv("RTAC_SIM");
  }
  static Outcome verified(const std::string& text, std::vector<std::string> more = {}) {
    write("spec.rta", text);
    std::vector<std::string> words = {"verify", "spec.rta"};
    words.insert(words.end(), more.begin(), more.end());
    return rtac(words);
  }
  // The statuses of one kind of obligation, of a monitor.
  static std::vector<std::string> statuses(const std::string& json, const std::string& kind,
                                           const std::string& monitor) {
    std::vector<std::string> found;
    const Json report = Json::parse(json);
    for (const Json& d : report["decisions"]) {
      for (const Json& o : d["obligations"]) {
        if (o["obligation"] == kind && o.value("monitor", "") == monitor) {
          found.push_back(o["status"]);
        }
      }
    }
    return found;
  }
};
using Statuses = std::vector<std::string>;

// Specifications that are refuted, by name, each a file in there whose first line says what is; the
// other files are what they share.
inline const std::string& refuted_folder() {
  static const std::string path = std::string(RTAC_SOURCE_DIR) + "/tests/compiler/verify/refuted/";
  return path;
}
inline std::vector<std::string> refuted_names() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(refuted_folder())) {
    if (read(entry.path()).rfind("// refuted: ", 0) != 0) continue;
    all.push_back(entry.path().stem().string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// A point mass, alone, that nobody pushes.
inline const std::string a_rover = R"(robot Rover {
  body radius 20 cm;
  motion point { speed <= 1.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 10 ms;
}
fleet r1 : Rover;
controller drive : advanced for Rover extern;
)";

// The same in space.
inline const std::string a_quad = R"(robot Quad {
  body radius 30 cm;
  motion point { speed <= 3 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense position : point3 error 5 cm max_age 50 ms;
  sense velocity : vector3 error 5 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
)";

}  // namespace rtac::driver::test
