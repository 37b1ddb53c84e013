#include <algorithm>
#include <numeric>

#include "compiler/protocol/protocol.h"
#include "compiler/protocol/texts.h"

namespace rtac::protocol {

namespace {

// A longer dwell does nothing that a shorter one with a later return condition does not
// (compiler/docs/protocol.md), and every tick of it multiplies the states.
constexpr std::int64_t dwell_ticks_max = 3, dwell_ticks_max_of_many = 1;
constexpr std::size_t many = 5;  // monitors
std::int64_t dwell_ticks(const Subject& s) {
  return std::min(s.dwell_ticks,
                  s.monitors.size() < many ? dwell_ticks_max : dwell_ticks_max_of_many);
}
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

std::string head(const Subject& s, const std::string& source) {
  const std::string at = s.on_plan ? ", on a plan" : ", every " + millis(s.period_us);
  std::string text = "/* Switching protocol of the decision `" + s.decision + "` for " + s.robot +
                     at + ", as `rtac protocol` writes it\n * of " + in_comment(source) +
                     ". Each claim at the end is checked, and a run that breaks it is told, by\n"
                     " *   spin -search -a -ltl CLAIM " +
                     s.decision + ".pml\n" + " *   spin -t -T -B " + s.decision +
                     ".pml\n *\n * Monitors, highest first:\n";
  for (std::size_t k = 0; k < s.monitors.size(); ++k) {
    text += " *   " + num(std::int64_t(k)) + " " + s.monitors[k].name + ": " +
            in_comment(s.monitors[k].about) + "\n";
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

std::string table(const std::string& name, const std::string& why, const Table& rows,
                  const Subject& s) {
  std::size_t width = 0;
  for (const Monitor& m : s.monitors) width = std::max(width, m.recovery.size());
  std::string text = "/* " + why + " */\nhidden byte " + name + "[MONITORS * MONITORS] = {\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string row = s.monitors[i].recovery;
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

// Monitors that stay, or lead to some that stay, when again and again one is taken away whose
// recovery is shown to keep all that are left of it and of those above it, are in a circle
// (language rule 12.1); the others are covered.
bool is_covered(const Subject& s, std::size_t judged) {
  std::vector<std::size_t> left(judged + 1);
  std::iota(left.begin(), left.end(), std::size_t{0});
  const auto keeps_all = [&](std::size_t i) {
    return std::all_of(left.begin(), left.end(), [&](std::size_t j) { return s.shown[i][j] != 0; });
  };
  for (;;) {
    const auto next = std::find_if(left.begin(), left.end(), keeps_all);
    if (next == left.end()) return std::find(left.begin(), left.end(), judged) == left.end();
    left.erase(next);
  }
}

std::string table_shown(const Subject& s) {
  std::string shown;
  for (const std::vector<int>& row : s.shown) {
    for (const int kept : row) {
      shown += (shown.empty() ? "" : ", ") + num(static_cast<std::int64_t>(kept));
    }
  }
  return "/* What the recovery of a row is shown to keep" +
         std::string(s.coordinated ? ", to coordinate by" : " of what ranks higher") +
         "; 2: its own monitor. */\nhidden byte shown[MONITORS * MONITORS] = { " + shown + " };\n";
}

std::string coordination(const Subject& s) {
  std::string covered;
  for (std::size_t i = 0; i < s.shown.size(); ++i) {
    covered += (i == 0 ? "" : ", ") + num(is_covered(s, i) ? 1 : 0);
  }
  return "/* Monitors that no circle of recoveries leads to. */\n"
         "hidden byte covered[MONITORS] = { " +
         covered + " };\n";
}

std::string numbers(const Subject& s, const Arbitration& a) {
  std::string text = "#define MONITORS " + num(std::int64_t(s.monitors.size())) + "\n";
  std::vector<std::string> monitors, drivers = {s.advanced};
  std::string ahead, asks;
  for (const Monitor& m : s.monitors) {
    monitors.push_back(m.name);
    drivers.push_back(m.recovery);
    const char* const comma = ahead.empty() ? "" : ", ";
    ahead += comma + num(std::clamp<std::int64_t>(m.ahead_ticks, 1, ahead_ticks_max));
    asks += comma + num(m.asks ? 1 : 0);
  }
  text += "#define DWELL " + num(dwell_ticks(s)) + " /* ticks that return conditions hold";
  if (s.dwell_ticks > dwell_ticks(s)) text += "; " + num(s.dwell_ticks) + " in truth";
  text += " */\n#define PROMISES " + std::string(s.promises ? "1" : "0") +
          " /* robots promise each other to stay */\n#define SURRENDERS_TO " +
          num(s.surrenders_to) + " /* who drives when control is given up */\n\n";
  text += "/* Ticks of the look-ahead of each monitor. */\nhidden byte ahead[MONITORS] = { " +
          ahead + " };\n/* Whether it has a `return when`. */\nhidden byte asks[MONITORS] = { " +
          asks + " };\n";
  text +=
      table("keeps", "While the recovery of the row drives, the monitor of the column stays idle.",
            a.keeps, s);
  text += table("settles",
                "Where the recovery of the row may return, the monitor of the column could too.",
                a.settles, s);
  if (!s.shown.empty()) text += table_shown(s);
  if (s.coordinated) text += coordination(s);
  return text + "\n" + says("say_monitor", monitors) + says("say_driver", drivers) + "\n";
}

Model plan_model(const Subject& s, const std::string& source) {
  std::vector<std::string> monitors;
  for (const Monitor& m : s.monitors) monitors.push_back(m.name);
  Model model;
  model.decision = s.decision;
  model.monitors = s.monitors.size();
  model.rules = head(s, source) + "\n#define MONITORS " + num(std::int64_t(s.monitors.size())) +
                "\n\n" + says("say_monitor", monitors) +
                "inline say_planner(planner) {\n  if\n  :: planner == advanced -> printf(\"`" +
                s.advanced + "`\")\n  :: else -> printf(\"`" + s.safe + "`\")\n  fi\n}\n\n" +
                plan_text;
  model.claims = std::string("\n") + plan_claims_text;
  model.claim_names = {"one_controller", "admissible_only", "scheduled", "answered"};
  return model;
}

// Each place is there once: the tests of the model would fail.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// After what a monitor does with what is found of it, `part` takes a note of that.
void take_notes(std::string& rules, const std::string& part) {
  rules = replaced(rules, "  :: engaged[m] -> open = SOMEBODY\n  :: else\n  fi\n",
                   "  :: engaged[m] -> open = SOMEBODY\n  :: else\n  fi;\n  note(m)\n");
  const std::size_t judged = rules.find("/* `monitor_step` of the kernel. */");
  rules.insert(judged, part + "\n");
}

// By priority, with recoveries that drive on.
void drive_on(Model& model) {
  std::string& rules = model.rules;
  take_notes(rules, drives_on_text);
  rules = replaced(rules, "inline decide() {\n  find_highest();\n",
                   "inline decide() {\n  find_highest();\n  find_going_on();\n");
  rules = replaced(rules, "  :: highest != NOBODY -> mode = highest + 1\n",
                   "  :: highest != NOBODY && goes_on -> mode = before\n"
                   "  :: highest != NOBODY && !goes_on -> mode = highest + 1\n");
  std::string& environment = model.environment;
  environment =
      replaced(environment, "  if\n  :: highest != NOBODY && !drives[highest + 1] -> waiting++",
               "  find_excuse();\n"
               "  if\n  :: highest != NOBODY && !drives[highest + 1] && !excused -> waiting++");
  environment =
      replaced(environment, "  home = 0;\n", "  home = 0;\n  goes_on = 0;\n  excused = 0;\n");
  model.claims = replaced(
      model.claims,
      "/* The recovery of the highest engaged monitor drives before its look-ahead has passed. */",
      "/* The recovery of the highest engaged monitor drives before its look-ahead has passed, or "
      "one\n"
      " * that is shown to keep each that ranks above its own. */");
}

// Where a decision that coordinates differs from one by priority.
void coordinate(Model& model) {
  std::string& rules = model.rules;
  take_notes(rules, coordinate_text);
  rules =
      replaced(rules, "highest != NOBODY -> mode = highest + 1", "highest != NOBODY -> choose()");
  rules = replaced(rules, "     mode = open + 1\n", "     choose()\n");
  std::string& environment = model.environment;
  environment = replaced(environment, "inline clear_check() {",
                         std::string(coordinate_environment_text + 1) + "\ninline clear_check() {");
  // who is led out of a violation stays out of it, and who drives keeps what can be kept
  environment = replaced(
      environment, "     :: else -> either(violated); either(clear)\n",
      "     :: calm && covered[m] && !(m != own && !engaged[m] && KEEPS(m)) -> either(clear)\n"
      "     :: else -> either(violated); either(clear)\n");
  environment = replaced(environment, "       choose_rest();\n",
                         "       choose_rest();\n       choose_ahead();\n");
  // nobody else has to drive soon: `kept` says who may
  environment = replaced(environment,
                         "  if\n  :: highest != NOBODY && !drives[highest + 1] -> waiting++\n"
                         "  :: else -> waiting = 0\n  fi;\n"
                         "  overdue = (highest != NOBODY && waiting >= ahead[highest]);\n",
                         "  find_lost();\n  forget();\n");
  model.claims = replaced(
      model.claims,
      "/* The recovery of the highest engaged monitor drives before its look-ahead has passed. */\n"
      "ltl scheduled { [] (decided -> !overdue) }",
      "/* Whoever drives while some monitor is engaged keeps every monitor that no circle of\n"
      " * recoveries leads to, while it and all above it are true. */\n"
      "ltl kept_by_driver { [] (decided -> !lost) }");
  model.claim_names[1] = "kept_by_driver";
}

}  // namespace

std::string text_of(const Table& table) {
  std::string text;
  for (const std::vector<bool>& row : table) {
    if (!text.empty()) text += ' ';
    for (const bool entry : row) text += entry ? '1' : '0';
  }
  return text;
}

Table table_of(const std::string& text) {
  Table table(text.empty() ? 0 : 1);
  for (const char c : text) {
    if (c == ' ') {
      table.emplace_back();
    } else if (c == '0' || c == '1') {
      table.back().push_back(c == '1');
    } else {
      return {};
    }
  }
  const auto square = [&](const std::vector<bool>& row) { return row.size() == table.size(); };
  return std::all_of(table.begin(), table.end(), square) ? table : Table();
}

Model protocol_model(const Subject& s, const Arbitration& arbitration, const std::string& source) {
  if (s.on_plan) return plan_model(s, source);
  Model model;
  model.decision = s.decision;
  model.monitors = s.monitors.size();
  model.rules = head(s, source) + "\n" + numbers(s, arbitration) + rules_text + "\n" + story_text;
  model.environment = std::string("\n") + environment_text;
  model.claims = std::string("\n") + claims_text;
  model.claim_names = {"one_controller", "scheduled", "given_back", "no_livelock",
                       "control_returns"};
  model.coordinated = s.coordinated;
  if (s.coordinated) {
    coordinate(model);
  } else if (!s.shown.empty()) {
    drive_on(model);
  }
  return model;
}

}  // namespace rtac::protocol
