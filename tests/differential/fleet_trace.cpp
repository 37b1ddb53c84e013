#include "tests/differential/fleet_trace.h"

#include <cstdio>
#include <sstream>
#include <utility>

namespace rtac::differential {

FleetTrace FleetTracer::trace(int rows) {
  FleetTrace trace{"time,permit,load,mode", {}};
  for (const char* const robot : {",q1.", ",q2.", ",q3."}) {
    for (const char* const signal :
         {"position.x", "position.y", "velocity.x", "velocity.y", "battery", "present"}) {
      trace.text += std::string(robot) + signal;
    }
  }
  trace.text += "\n";
  int tick = 0;
  for (int row = 0; row < rows;
       ++row, tick += chance(12) ? 1 + static_cast<int>(random_() % 8) : 1) {
    const bool whole = chance(2);
    trace.text += number(0.05 * tick) + ",";
    trace.text += (chance(3) ? "" : chance(2) ? "1" : "0") + std::string(",");
    trace.text += (chance(4) ? "" : number(uniform(0, 11))) + "," + (chance(2) ? "idle" : "busy");
    for (int robot = 0; robot < 3; ++robot) trace.text += whole ? at_rest() : any();
    trace.text += "\n";
    trace.whole.push_back(whole);
  }
  return trace;
}

// To the micrometre or to the millimetre.
std::string FleetTracer::number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, chance(2) ? "%.6f" : "%.3f", value);
  return text;
}

// Near an edge, near each other, anywhere.
std::string FleetTracer::coordinate() {
  const double edges[] = {-3.9, -3.8, 3.9, 0.0, 1.0, 2.1};
  if (chance(3)) return number(edges[random_() % 6] + uniform(-0.05, 0.05));
  return number(chance(20) ? uniform(-9, 9) : uniform(-4.2, 4.2));
}

std::string FleetTracer::charge() {
  return number(chance(4) ? uniform(-0.02, 1.02) : uniform(0.1, 0.3));
}

std::string FleetTracer::at_rest() {
  return "," + coordinate() + "," + coordinate() + ",0,0," + charge() + ",1";
}

std::string FleetTracer::sometimes(const std::string& value) {
  if (chance(4)) return ",";
  return "," + (chance(20) ? "nan" : value);
}

std::string FleetTracer::any() {
  const std::string x = sometimes(coordinate()), y = x == "," ? "," : sometimes(coordinate());
  const std::string v = sometimes(number(uniform(-0.36, 0.36)));
  const std::string presence = chance(8) ? "0" : chance(2) ? "1" : "";
  return x + y + v + (v == "," ? "," : "," + number(uniform(-0.36, 0.36))) + sometimes(charge()) +
         "," + presence;
}

FindingTable finding_table(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> names;
  FindingTable rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line + ",");
    FindingRow row;
    std::size_t at = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++at) {
      if (rows.empty() && line.rfind("tick,", 0) == 0) {
        names.push_back(cell);
      } else {
        row[names[at]] = cell;
      }
    }
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace rtac::differential
