#include "kills.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
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
      {"no-stopping-distance", "glider", "aimed-noise", 20},
      {"strong-brake", "glider", "aimed-noise", 20},
      {"no-position-error", "drifter", "aimed-noise", 20},
      {"no-velocity-error", "swayer", "aimed-noise", 20},
      {"no-noise", "drifter", "aimed-noise", 20},
      {"no-radius", "glider", "aimed-noise", 20},
      {"no-tube", "late_brake", "aimed-noise", 20},
      {"or-for-and", "two_halls", "chase-fence", 20},
      {"lowest-priority-drives", "order", "chase-fence", 20, "order.json"},
      {"no-message-age", "pair", "chase-robot", 20},
      {"others-stand", "pair", "chase-robot", 20},
      {"open-gate", "gate", "drop-outs", 60},
      {"stale-charge", "fuel", "drain", 20},
  };
  return all;
}

Attack attack(const Row& row, const std::string& mutant, int runs) {
  const fs::path folder =
      fs::temp_directory_path() / ("rtac_kills_" + std::to_string(::getpid()) + "_" + row.mutant);
  fs::create_directories(folder);
  const std::string command = std::string("'") + RTAC_PROGRAM + "' sim '" + RTAC_CAMPAIGN_SPECS +
                              "/" + row.spec + ".rta' --adversary " + row.adversary + " --runs " +
                              std::to_string(runs) + (mutant.empty() ? "" : " --mutate " + mutant) +
                              (*row.scenario == '\0' ? std::string()
                                                     : " --scenario '" RTAC_CAMPAIGN_SPECS "/" +
                                                           std::string(row.scenario) + "'") +
                              " --trace '" + (folder / "run.trace").string() + "' >'" +
                              (folder / "out").string() + "' 2>&1";
  const int status = std::system(command.c_str());
  Attack result;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.said = text_of(folder / "out");
  result.depth = after(result.said, "down to ", "\n");
  result.seed = std::strtoull(after(result.said, "--seed ", " ").c_str(), nullptr, 10);
  fs::remove_all(folder);
  return result;
}

std::string kill_table_text() {
  constexpr std::size_t widest = 160;
  char line[widest];
  std::snprintf(line, widest, "%-28s %-12s %-16s %6s %12s\n", "mutant", "scenario", "adversary",
                "seed", "margin");
  std::string text = line;
  for (const Row& row : kill_table()) {
    const Attack a = attack(row, row.mutant, row.runs);
    const std::string seed = a.status == 3 ? std::to_string(a.seed) : "-";
    std::snprintf(line, widest, "%-28s %-12s %-16s %6s %12s\n", row.mutant, row.spec, row.adversary,
                  seed.c_str(), a.status == 3 ? a.depth.c_str() : "survives");
    text += line;
  }
  return text;
}

}  // namespace rtac::campaign
