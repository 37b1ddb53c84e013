// The language reference, rule by rule: its examples, and the tables of what their monitors find.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/compiler/docs/fences.h"

namespace rtac::docs {

inline const fs::path reference = fs::path(RTAC_SOURCE_DIR) / "compiler/docs/language.md";

// "2.1" of "### Rule 2.1 once"; empty for other headings.
inline std::string rule_of_heading(const std::string& line) {
  std::istringstream words(line);
  std::string level, rule, number;
  words >> level >> rule >> number;
  return level == "###" && rule == "Rule" ? number : "";
}

// The fences below each heading of a rule, in order.
inline std::vector<std::pair<std::string, std::vector<Fence>>> rules() {
  std::vector<std::pair<std::string, std::vector<Fence>>> all;
  std::map<int, std::string> headings;  // by line
  std::istringstream lines(driver::test::read(reference));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.rfind("#", 0) == 0) headings[number] = rule_of_heading(line);
  }
  for (const auto& [line, rule] : headings) {
    if (!rule.empty()) all.push_back({rule, {}});
  }
  for (const Fence& fence : fences_of(reference)) {
    auto heading = headings.upper_bound(fence.line);
    if (heading == headings.begin()) continue;
    const std::string rule = (--heading)->second;
    for (auto& [each, fences] : all) {
      if (each == rule) fences.push_back(fence);
    }
  }
  return all;
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) {
    const auto begin = part.find_first_not_of(' ');
    const auto end = part.find_last_not_of(' ');
    parts.push_back(begin == std::string::npos ? "" : part.substr(begin, end - begin + 1));
  }
  return parts;
}

// "true", "true 0.4 m" (verdict, margin, unit), or "false or unknown".
inline bool is_as_due(const std::string& due, const std::string& verdict, const std::string& margin,
                      const std::string& unit) {
  for (std::size_t begin = 0, at = 0; at != std::string::npos; begin = at + 4) {
    at = due.find(" or ", begin);
    const std::string one = due.substr(begin, at == std::string::npos ? at : at - begin);
    std::istringstream words(one);
    std::string due_verdict, due_margin, due_unit;
    words >> due_verdict >> due_margin >> due_unit;
    if (due_verdict == verdict && (due_margin.empty() || due_margin == margin) &&
        (due_unit.empty() || due_unit == unit)) {
      return true;
    }
  }
  return false;
}

// The cells of `m`, verdict, margin and unit; of `m.return` there is a verdict alone.
inline std::vector<std::string> cells_of(const std::string& name,
                                         const std::vector<std::string>& header,
                                         const std::vector<std::string>& cells) {
  for (std::size_t k = 0; k < header.size() && k < cells.size(); ++k) {
    if (header[k] == name + ".verdict") return {cells[k], cells[k + 1], cells[k + 2]};
    if (header[k] == name) return {cells[k], "", ""};
  }
  return {};
}

// A table `time,p => m ; n` of spec.rta, replayed by an engine.
inline void expect_findings(const Fence& table, const std::string& engine) {
  std::vector<std::pair<std::string, std::string>> rows;  // cells of the trace, what is due
  std::string trace;
  for (const std::string& line : split(table.text, '\n')) {
    const std::size_t arrow = line.find("=>");
    ASSERT_NE(arrow, std::string::npos) << line;
    rows.push_back({line.substr(0, arrow), line.substr(arrow + 2)});
    trace += rows.back().first + "\n";
  }
  driver::test::write("trace.csv", trace);
  const auto outcome = driver::test::rtac({"replay", "--engine", engine, "spec.rta", "trace.csv"});
  const auto found = split(outcome.out, '\n');
  ASSERT_EQ(found.size(), rows.size()) << outcome.err;
  const auto monitors = split(rows[0].second, ';');
  const auto header = split(found[0], ',');
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto due = split(rows[i].second, ';');
    const auto cells = split(found[i] + ",", ',');
    ASSERT_EQ(due.size(), monitors.size()) << rows[i].first;
    for (std::size_t m = 0; m < monitors.size(); ++m) {
      const auto is = cells_of(monitors[m], header, cells);
      ASSERT_FALSE(is.empty()) << "no monitor " << monitors[m];
      EXPECT_TRUE(is_as_due(due[m], is[0], is[1], is[2]))
          << engine << ", line " << table.line << ", row " << rows[i].first << ": " << monitors[m]
          << " is " << is[0] << " " << is[1] << " " << is[2] << ", due is " << due[m];
    }
  }
}

// Every example of a rule compiles or gives its code; every table is what both engines find.
inline void expect_as_shown(const std::string& rule) {
  const Workbench workbench;
  int examples = 0;
  for (const auto& [number, fences] : rules()) {
    if (number != rule) continue;
    for (const Fence& fence : fences) {
      if (fence.language == "rta") {
        const Said result = Workbench::run(fence);
        EXPECT_EQ(result.codes, fence.listed("error")) << "line " << fence.line << result.text;
        ++examples;
      } else {
        expect_findings(fence, "interp");
        expect_findings(fence, "kernel");
      }
    }
  }
  EXPECT_GE(examples, 1) << "rule " << rule << " has no example";
}

}  // namespace rtac::docs
