#include <algorithm>

#include "compiler/protocol/protocol.h"
#include "compiler/protocol/texts.h"

namespace rtac::protocol {

using namespace ir;

namespace {

// A longer dwell does nothing that a shorter one with a later return condition does not
// (compiler/docs/protocol.md), and every tick of it multiplies the states.
constexpr std::int64_t dwell_ticks_max = 3;
// Of a byte of the model.
constexpr std::int64_t ahead_ticks_max = 200;

std::string num(std::int64_t value) {
  return std::to_string(value);
}
std::string millis(std::int64_t us) {
  return num(us / 1000) + (us % 1000 == 0 ? "" : "." + num(1000 + us % 1000).substr(1)) + " ms";
}
// Nothing that the author writes ends a comment of the model.
std::string in_comment(std::string text) {
  for (std::size_t at = text.find("*/"); at != std::string::npos; at = text.find("*/", at)) {
    text.replace(at, 2, "* /");
  }
  return text;
}

// Is some property about other robots? Then robots promise each other to stay.
bool judges_others(const Block& block) {
  return std::any_of(block.values.begin(), block.values.end(),
                     [](const Value& v) { return body_of(v.op) != nullptr; });
}
bool has_promises(const Decision& d) {
  const auto& facts = d.facts.monitors;
  return std::any_of(facts.begin(), facts.end(),
                     [](const PlainMonitor& fact) { return judges_others(fact.property); }) ||
         std::any_of(d.monitors.begin(), d.monitors.end(), [](const Monitor& m) {
           return judges_others(m.property) || (m.ahead && judges_others(*m.ahead)) ||
                  (m.return_when && judges_others(*m.return_when));
         });
}

// Ticks of its look-ahead, the one in which it fails included.
std::int64_t ahead_ticks(const Decision& d, const Monitor& m) {
  if (!m.lookahead.duration) return 1;
  return std::clamp<std::int64_t>(m.lookahead.duration_us / d.period_us, 1, ahead_ticks_max);
}

std::string head(const Decision& d, const std::string& source) {
  const std::string at = d.on_plan ? ", on a plan" : ", every " + millis(d.period_us);
  std::string text = "/* Switching protocol of the decision `" + d.name + "` for " + d.kind + at +
                     ", as `rtac protocol` writes it\n * of " + in_comment(source) +
                     ". Each claim at the end is checked, and a run that breaks it is told, by\n"
                     " *   spin -search -a -ltl CLAIM " +
                     d.name + ".pml\n" + " *   spin -t -T -B " + d.name +
                     ".pml\n *\n * Monitors, highest first:\n";
  for (std::size_t k = 0; k < d.monitors.size(); ++k) {
    const Monitor& m = d.monitors[k];
    const std::string id = m.requirement_id.empty() ? "" : m.requirement_id + ": ";
    text += " *   " + num(std::int64_t(k)) + " " + m.name + ": " +
            in_comment(id + m.requirement_text) + " (" + in_comment(m.file) + ":" + num(m.line) +
            ")\n";
  }
  return text + " */\n";
}

std::string says(const std::string& name, const std::vector<std::string>& words) {
  std::string text = "inline " + name + "(number) {\n  if\n";
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += "  :: number == " + num(std::int64_t(k)) + " -> printf(\"`" + words[k] + "`\")\n";
  }
  return text + "  :: else -> printf(\"nobody\")\n  fi\n}\n";
}

std::string table(const std::string& name, const std::string& why,
                  const std::vector<std::vector<bool>>& rows, const Decision& d) {
  std::size_t width = 0;
  for (const Monitor& m : d.monitors) width = std::max(width, m.recovery.name.size());
  std::string text = "/* " + why + " */\nhidden byte " + name + "[MONITORS * MONITORS] = {\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string row = d.monitors[i].recovery.name;
    row.resize(width, ' ');
    text += "  /* " + row + " */ ";
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const bool last = i + 1 == rows.size() && j + 1 == rows[i].size();
      text += std::string(rows[i][j] ? "1" : "0") + (last ? "" : ",") +
              (j + 1 < rows[i].size() ? " " : "\n");
    }
  }
  return text + "};\n";
}

std::string numbers(const Decision& d, const Arbitration& a) {
  std::string text = "#define MONITORS " + num(std::int64_t(d.monitors.size())) + "\n";
  std::vector<std::string> monitors, drivers = {d.advanced};
  std::string ahead;
  for (const Monitor& m : d.monitors) {
    monitors.push_back(m.name);
    drivers.push_back(m.recovery.name);
    ahead += (ahead.empty() ? "" : ", ") + num(ahead_ticks(d, m));
  }
  text += "#define DWELL " + num(std::min(d.dwell_ticks, dwell_ticks_max)) +
          " /* ticks that return conditions hold";
  if (d.dwell_ticks > dwell_ticks_max) text += "; " + num(d.dwell_ticks) + " in truth";
  text += " */\n#define PROMISES " + std::string(has_promises(d) ? "1" : "0") +
          " /* robots promise each other to stay */\n#define SURRENDERS_TO " +
          num(surrender_mode(d)) + " /* who drives when control is given up */\n\n";
  text += "/* Ticks of the look-ahead of each monitor. */\nhidden byte ahead[MONITORS] = { " +
          ahead + " };\n";
  text +=
      table("keeps", "While the recovery of the row drives, the monitor of the column stays idle.",
            a.keeps, d);
  text += table("settles",
                "Where the recovery of the row may return, the monitor of the column could too.",
                a.settles, d);
  return text + "\n" + says("say_monitor", monitors) + says("say_driver", drivers) + "\n";
}

Model plan_model(const Decision& d, const std::string& source) {
  std::vector<std::string> monitors;
  for (const Monitor& m : d.monitors) monitors.push_back(m.name);
  Model model;
  model.decision = d.name;
  model.rules = head(d, source) + "\n#define MONITORS " + num(std::int64_t(d.monitors.size())) +
                "\n\n" + says("say_monitor", monitors) +
                "inline say_planner(planner) {\n  if\n  :: planner == advanced -> printf(\"`" +
                d.advanced + "`\")\n  :: else -> printf(\"`" + d.safe + "`\")\n  fi\n}\n\n" +
                plan_text;
  model.claims = std::string("\n") + plan_claims_text;
  model.claim_names = {"one_controller", "admissible_only", "scheduled", "answered"};
  return model;
}

}  // namespace

Arbitration assumed(const Decision& d) {
  const std::size_t count = d.monitors.size();
  std::vector<std::vector<bool>> rows(count, std::vector<bool>(count, true));
  for (const Acknowledgement& a : d.acknowledgements) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        if (d.monitors[i].recovery.name == a.recovery && d.monitors[j].name == a.monitor) {
          rows[i][j] = false;
        }
      }
    }
  }
  return {rows, rows};
}

Model protocol_model(const Decision& d, const Arbitration& arbitration, const std::string& source) {
  if (d.on_plan) return plan_model(d, source);
  Model model;
  model.decision = d.name;
  model.rules = head(d, source) + "\n" + numbers(d, arbitration) + rules_text + "\n" + story_text;
  model.environment = std::string("\n") + environment_text;
  model.claims = std::string("\n") + claims_text;
  model.claim_names = {"one_controller", "scheduled", "given_back", "no_livelock",
                       "control_returns"};
  return model;
}

}  // namespace rtac::protocol
