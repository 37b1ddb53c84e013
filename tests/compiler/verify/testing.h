// `rtac verify` of a specification in a folder of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {

using Json = nlohmann::json;

class Verify : public InFolder {
 protected:
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

}  // namespace rtac::driver::test
