#include "shares.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace rtac::campaign {
namespace {

namespace fs = std::filesystem;

std::string text_of_file(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

void replace_all(std::string& text, const std::string& mark, const std::string& by) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
    text.replace(at, mark.size(), by);
    at += by.size();
  }
}

std::string specification(const Experiment& e) {
  constexpr int usual_period_ms = 50;
  const int period_ms = e.one_period ? e.delta_ms : usual_period_ms;
  std::string ahead = std::to_string(e.one_period ? e.delta_ms : 2 * e.delta_ms) + " ms";
  if (e.command) ahead += ", command";
  std::string text = text_of_file(RTAC_SHARE_SPEC);
  const std::pair<const char*, std::string> marks[] = {
      {"@look@", e.command ? "command" : "any"},
      {"@period@", std::to_string(period_ms)},
      {"@ahead@", ahead},
      {"@recovery@", e.retreats ? "retreat within room speed 1 m/s" : "brake_and_hold"},
      {"@hold@", e.retreats ? "" : "hold when violated \"the experiment\"; "}};
  for (const auto& [mark, by] : marks) replace_all(text, mark, by);
  return text;
}

// The number behind the first `mark` that stands behind `from`.
double number_behind(const std::string& text, const std::string& from, const std::string& mark) {
  const std::size_t begin = text.find(from);
  const std::size_t at = begin == std::string::npos ? begin : text.find(mark, begin + from.size());
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + mark.size(), nullptr);
}

}  // namespace

const std::vector<TheoryRow>& theory_shares() {
  static const std::vector<TheoryRow> all = {{50, 7.5, 70.6, 0.03},
                                             {100, 2.4, 64.8, 0.06},
                                             {200, 2.6, 55.5, 0.20},
                                             {400, 1.9, 39.4, 0.67},
                                             {800, 0, 0, -1}};
  return all;
}

Measured measure(const Experiment& e) {
  const fs::path folder = fs::temp_directory_path() / ("rtac_shares_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto quoted = [](const fs::path& path) { return " '" + path.string() + "'"; };
  std::ofstream(folder / "share.rta") << specification(e);
  std::ofstream(folder / "scenario.json") << "{\"duration_s\": " << e.duration_s << "}\n";
  const std::string command = quoted(RTAC_PROGRAM) + " sim" + quoted(folder / "share.rta") +
                              " --scenario" + quoted(folder / "scenario.json") + " --runs " +
                              std::to_string(e.runs) + " --adversary " + e.adversary + " --trace" +
                              quoted(folder / "run.trace") + " >" + quoted(folder / "out") +
                              " 2>&1";
  const int status = std::system(command.c_str());
  Measured m;
  m.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  m.said = text_of_file(folder / "out");
  m.percent = number_behind(m.said, "", "advanced controller: ");
  m.clearance_m = number_behind(m.said, "\nwalls ", " % ");
  fs::remove_all(folder);
  return m;
}

}  // namespace rtac::campaign
