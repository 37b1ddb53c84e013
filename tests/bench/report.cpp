#include "tests/bench/report.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>

#include "rtac/sim/table.h"

namespace rtac::bench {

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return {median, values.front(), values.back()};
}

void Report::section(const std::string& title) {
  if (title != section_) std::fprintf(stderr, "%s\n", title.c_str());
  section_ = title;
}

void Report::add(const std::string& key, const std::string& what, const Spread& value,
                 const std::string& unit, int decimals) {
  rows_.push_back({section_, key, what, unit, value, decimals});
  std::fprintf(stderr, "  %s: %s %s\n", what.c_str(), sim::fixed(value.median, decimals).c_str(),
               unit.c_str());
}

void Report::add(const std::string& key, const std::string& what, double value,
                 const std::string& unit, int decimals) {
  add(key, what, Spread{value, value, value}, unit, decimals);
}

std::string Report::text() const {
  std::string all, section;
  sim::Table table({""});
  const auto flush = [&] {
    if (!section.empty()) all += section + "\n" + table.text() + "\n";
  };
  for (const Row& row : rows_) {
    if (row.section != section) {
      flush();
      section = row.section;
      table = sim::Table({"measured", "median", "unit", "lowest", "highest"});
    }
    const bool spread = row.value.low < row.value.high;
    table.row({row.what, sim::fixed(row.value.median, row.decimals), row.unit,
               spread ? sim::fixed(row.value.low, row.decimals) : "",
               spread ? sim::fixed(row.value.high, row.decimals) : ""});
  }
  flush();
  return all;
}

std::string Report::json() const {
  std::string all;
  for (const Row& row : rows_) {
    char line[400];
    std::snprintf(line, sizeof line,
                  "%s  \"%s\": {\"median\": %.6g, \"low\": %.6g, \"high\": %.6g, \"unit\": \"%s\"}",
                  all.empty() ? "" : ",\n", row.key.c_str(), row.value.median, row.value.low,
                  row.value.high, row.unit.c_str());
    all += line;
  }
  return "{\n" + all + "\n}\n";
}

std::string Report::lines() const {
  std::ostringstream out;
  out.precision(17);
  for (const Row& row : rows_) {
    out << row.section << '\t' << row.key << '\t' << row.what << '\t' << row.unit << '\t'
        << row.value.median << ' ' << row.value.low << ' ' << row.value.high << ' ' << row.decimals
        << '\n';
  }
  return std::move(out).str();
}

bool Report::add_lines(const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    Row row;
    for (std::string* text : {&row.section, &row.key, &row.what, &row.unit}) {
      if (!std::getline(words, *text, '\t')) return false;
    }
    if (!(words >> row.value.median >> row.value.low >> row.value.high >> row.decimals)) {
      return false;
    }
    rows_.push_back(row);
  }
  return true;
}

}  // namespace rtac::bench
