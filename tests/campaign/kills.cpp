#include "kills.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace rtac::campaign {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The word after `mark`.
std::string after(const std::string& text, const std::string& mark, const char* end) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + mark.size();
  return text.substr(begin, text.find_first_of(end, begin) - begin);
}

}  // namespace

const std::vector<Row>& kill_table() {
  static const std::vector<Row> all = {
      {"half-look-ahead", "dart", "aimed-noise", 20},
      {"no-look-ahead", "dart", "aimed-noise", 20},
      {"no-latency", "dart", "aimed-noise", 20},
      {"no-sample-age", "dart", "aimed-noise", 20},
      {"equal-stamps", "dart", "unequal-samples", 20},
      {"no-acceleration", "dart", "aimed-noise", 20},
      {"measured-speed-is-the-most", "dart", "aimed-noise", 20},
      {"half-look-ahead", "cart", "aimed-noise", 20},
      {"no-latency", "cart", "aimed-noise", 20},
      {"no-sample-age", "cart", "aimed-noise", 20},
      {"no-acceleration", "cart", "aimed-noise", 20},
      {"measured-speed-is-the-most", "cart", "aimed-noise", 20},
      {"no-stopping-distance", "cart", "aimed-noise", 20},
      {"strong-brake", "cart", "aimed-noise", 20},
      {"no-stopping-distance", "glider", "aimed-noise", 20},
      {"strong-brake", "glider", "aimed-noise", 20},
      {"no-position-error", "drifter", "aimed-noise", 20},
      {"no-velocity-error", "swayer", "aimed-noise", 20},
      {"no-noise", "drifter", "aimed-noise", 20},
      {"no-disturbance", "leaf", "gusts", 20},
      {"no-radius", "glider", "aimed-noise", 20},
      {"no-tube", "late_brake", "aimed-noise", 20},
      {"or-for-and", "two_halls", "chase-fence", 20},
      {"lowest-priority-drives", "order", "chase-fence", 20, "order.json"},
      {"never-gives-way", "order", "chase-fence", 20, "order.json"},
      {"shortest-prefix-drives", "shortest", "chase-fence", 20, "order.json"},
      {"points-only", "legs", "follow-plans", 20},
      {"no-message-age", "pair", "chase-robot", 20},
      {"others-stand", "pair", "chase-robot", 20},
      {"no-message-age", "starlings", "chase-robot", 20, "above.json"},
      {"others-stand", "starlings", "chase-robot", 20, "above.json"},
      {"agents-stand", "crossing", "chase-robot", 20},
      {"no-agent-age", "crossing", "chase-robot", 20},
      {"agents-stand", "templates/agents_space", "chase-robot", 20},
      {"open-gate", "gate", "drop-outs", 60},
      {"level-flight", "attic", "chase-fence", 20, "templates/space.json"},
      {"level-flight", "starlings", "chase-robot", 20, "above.json"},
      {"unchecked-claim", "templates/extern_point", "chase-fence", 20},
      {"no-lead", "templates/hours_point", "chase-fence", 20, "templates/point.json"},
      {"stale-charge", "fuel", "drain", 20},
  };
  return all;
}

Attack attack(const Row& row, const std::string& mutant, int runs) {
  const fs::path folder = fs::temp_directory_path() / ("rtac_attack_" + std::to_string(::getpid()) +
                                                       "_" + std::to_string(mutant.empty()));
  fs::create_directories(folder);
  const auto quoted = [](const fs::path& path) { return " '" + path.string() + "'"; };
  const fs::path specs = RTAC_CAMPAIGN_SPECS;
  std::string command = quoted(RTAC_PROGRAM) + " sim" +
                        quoted(specs / (std::string(row.spec) + ".rta")) + " --runs " +
                        std::to_string(runs) + " --trace" + quoted(folder / "run.trace");
  if (*row.adversary != '\0') command += std::string(" --adversary ") + row.adversary;
  if (*row.scenario != '\0') command += " --scenario" + quoted(specs / row.scenario);
  if (!mutant.empty()) command += " --mutate " + mutant;
  command += " >" + quoted(folder / "out") + " 2>&1";
  const int status = std::system(command.c_str());
  Attack result;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.said = text_of(folder / "out");
  result.depth = after(result.said, "down to ", "\n");
  result.seed = std::strtoull(after(result.said, "--seed ", " ").c_str(), nullptr, 10);
  fs::remove_all(folder);
  return result;
}

}  // namespace rtac::campaign
