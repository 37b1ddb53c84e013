// What was measured, as a table for people and as JSON for machines. Each row goes to the error
// stream as soon as it is known: a run takes minutes, and what it has found is kept when it ends
// early.
#pragma once

#include <string>
#include <vector>

namespace rtac::bench {

// Median of repeated measurements, and their range.
struct Spread {
  double median = 0, low = 0, high = 0;
};
Spread spread_of(std::vector<double> values);

class Report {
 public:
  void section(const std::string& title);
  // `key` names the value in the JSON file and is unique; `decimals` are those of the table.
  void add(const std::string& key, const std::string& what, const Spread& value,
           const std::string& unit, int decimals);
  void add(const std::string& key, const std::string& what, double value, const std::string& unit,
           int decimals);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string json() const;
  // One line per row, and back again: for what another program has measured. False: not such lines.
  [[nodiscard]] std::string lines() const;
  bool add_lines(const std::string& lines);

 private:
  struct Row {
    std::string section, key, what, unit;
    Spread value;
    int decimals = 0;
  };
  std::vector<Row> rows_;
  std::string section_;
};

}  // namespace rtac::bench
