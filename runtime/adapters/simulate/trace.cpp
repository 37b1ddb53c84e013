#include "trace.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace rtac::simulate {
namespace {

constexpr const char* first_line = "rtac-sim-trace 3";

std::string hex(double value) {
  constexpr std::size_t widest = 32;
  char text[widest];
  std::snprintf(text, widest, " %a", value);
  return text;
}

std::string start_line(const std::string& robot, const RobotStart& s) {
  return "start " + robot + hex(s.place.x) + hex(s.place.y) + hex(s.heading_rad) + hex(s.battery) +
         hex(s.height_m) + "\n";
}

// Of each component what is so, and what is measured.
std::string inputs_line(const Told& told) {
  std::string line = "inputs";
  for (std::size_t k = 0; k < told.is.size(); ++k) line += hex(told.is[k]) + hex(told.measured[k]);
  return line + "\n";
}

double real(std::istream& in) {
  std::string word;
  in >> word;
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) in.setstate(std::ios::failbit);
  return value;
}

// The only noise that the world has to know, because of its wind.
constexpr const char* lasting_noise = "lasting";

// The year 9999.
constexpr TimeUs begins_us_max = 253'402'300'800'000'000;

// The lines before the tape.
bool read_head(const std::string& word, std::istream& in, Trace& to) {
  if (word == "specification") {
    in >> to.specification;
  } else if (word == "manifest") {
    in >> std::hex >> to.manifest_hash >> std::dec;
  } else if (word == "decision") {
    in >> to.decision;
  } else if (word == "seed") {
    in >> to.setup.seed;
  } else if (word == "duration_us") {
    constexpr TimeUs duration_us_max = 10 * 86'400'000'000;  // with what is looked ahead
    in >> to.setup.duration_us;
    if (to.setup.duration_us <= 0 || to.setup.duration_us > duration_us_max) return false;
  } else if (word == "begins_us") {
    in >> to.setup.begins_us;
    if (to.setup.begins_us < 0 || to.setup.begins_us > begins_us_max) return false;
  } else if (word == "about") {
    in >> to.about;
  } else if (word == "undecided") {
    in >> to.setup.undecided;
  } else if (word == "return_within_us") {
    in >> to.setup.return_within_us;
    if (to.setup.return_within_us <= 0) return false;
  } else if (word == "adversary") {
    std::string name;
    in >> name;
    to.setup.adversary = find_adversary(name);
    if (to.setup.adversary == nullptr) return false;
  } else if (word == "noise") {
    std::string kind;
    in >> kind;
    if (kind != lasting_noise) return false;
    to.setup.hostility.noise = sim::Noise::lasting;
  } else if (word == "inputs") {
    while (in >> std::ws && !in.eof()) {
      to.setup.told.is.push_back(real(in));
      to.setup.told.measured.push_back(real(in));
      if (in.fail()) return false;
    }
    in.clear();
  } else if (word == "start") {
    std::string robot;
    in >> robot;
    RobotStart s;
    s.place.x = real(in);
    s.place.y = real(in);
    s.heading_rad = real(in);
    s.battery = real(in);
    s.height_m = real(in);
    to.setup.starts.push_back(s);
  } else {
    return false;
  }
  return !in.fail();
}

Problem unreadable(const std::string& why) {
  return {"the recorded run cannot be played: " + why,
          "`rtac sim` writes one when a property is violated"};
}

// Whatever is changed, if only in what nobody uses, another line follows.
std::string with_hash(std::string text) {
  constexpr std::size_t widest = 32;
  char hash[widest];
  std::snprintf(hash, widest, "hash %016" PRIx64 "\n", hash_of(text));
  return text += hash;
}

}  // namespace

std::string trace_text(const Case& all, const DecisionCase& decision, const Setup& setup,
                       const Outcome& outcome, const std::vector<std::string>& tape) {
  constexpr std::size_t widest = 32;
  char hash[widest];
  std::snprintf(hash, widest, "%016" PRIx64, all.hash);
  std::string text =
      std::string(first_line) + "\nspecification " + all.specification + "\nmanifest " + hash +
      "\ndecision " + decision.name + "\nseed " + std::to_string(setup.seed) + "\nduration_us " +
      std::to_string(setup.duration_us) + "\nadversary " + setup.adversary->name + "\n";
  if (setup.begins_us > 0) text += "begins_us " + std::to_string(setup.begins_us) + "\n";
  if (setup.hostility.noise == sim::Noise::lasting) {
    text += std::string("noise ") + lasting_noise + "\n";
  }
  if (setup.about >= 0) {
    text += "about " + decision.monitors[static_cast<std::size_t>(setup.about)].name + "\n";
  }
  if (setup.undecided) text += "undecided 1\n";
  if (setup.return_within_us > 0) {
    text += "return_within_us " + std::to_string(setup.return_within_us) + "\n";
  }
  if (!setup.told.is.empty()) text += inputs_line(setup.told);
  for (std::size_t i = 0; i < setup.starts.size(); ++i) {
    text += start_line(decision.robots[i], setup.starts[i]);
  }
  text += "tape\n";
  for (const std::string& line : tape) text += line + "\n";
  if (const Kept& k = outcome.kept; k.robot >= 0) {
    text += std::string("end ") + (setup.undecided ? "undecided: " : "not given back: ") +
            decision.robots[static_cast<std::size_t>(k.robot)] + " from_us " +
            std::to_string(k.from_us) + " until_us " + std::to_string(k.until_us) + "\n";
  }
  const sim::Violation& v = outcome.violation;
  if (v.time_us == never_us) return with_hash(text + "end no violation\n");
  const auto monitor = static_cast<std::size_t>(v.monitor);
  return with_hash(text + "end violation of " + decision.monitors[monitor].name + " by " +
                   decision.robots[static_cast<std::size_t>(v.robot)] + " at_us " +
                   std::to_string(v.time_us) + " least" + hex(outcome.least[monitor].value) + "\n");
}

Problem read_trace(const std::string& text, const Case& all, Trace& to) {
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line) || line != first_line) return unreadable("it is no recorded run");
  int number = 1;
  for (; std::getline(in, line) && line != "tape";) {
    ++number;
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (!read_head(word, words, to)) return unreadable("line " + std::to_string(number));
  }
  while (std::getline(in, line)) to.tape.push_back(line);
  const auto d = std::find_if(all.decisions.begin(), all.decisions.end(),
                              [&](const DecisionCase& each) { return each.name == to.decision; });
  if (to.manifest_hash != all.hash || d == all.decisions.end() ||
      to.setup.starts.size() != d->robots.size() || !can_be(*d, to.setup.told) ||
      to.setup.adversary == nullptr) {
    return unreadable("it is of another specification, or of another version of this one");
  }
  to.setup.of_robot.assign(d->robots.size(), to.setup.adversary);
  if (to.about.empty()) return {};
  for (std::size_t m = 0; m < d->monitors.size(); ++m) {
    if (d->monitors[m].name == to.about) to.setup.about = static_cast<int>(m);
  }
  if (to.setup.about < 0) return unreadable("no monitor is called `" + to.about + "`");
  return {};
}

}  // namespace rtac::simulate
