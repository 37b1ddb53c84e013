#include "compiler/contract/notes.h"

#include <cctype>
#include <sstream>

namespace rtac::contract {
namespace {

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// KERNEL_plan -> delivery_plan, VERDICT_TRUE -> DELIVERY_VERDICT_TRUE
std::string prefixed(const std::string& line, const std::string& prefix) {
  static const std::string kernel = "KERNEL_";
  std::string upper, out;
  for (const char c : prefix) {
    upper += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && is_word(line[end])) ++end;
    if (end == i) {
      out += line[i++];
      continue;
    }
    std::string word = line.substr(i, end - i);
    if (starts_with(word, kernel)) word = prefix + "_" + word.substr(kernel.size());
    for (const char* family : {"REASON_", "INPUT_", "VERDICT_", "GATE_"}) {
      if (starts_with(word, family)) word = upper + "_" + word;
    }
    out += word;
    i = end;
  }
  return out;
}

bool defines(const std::string& kernel, const std::string& function) {
  return kernel.find(" " + function + "(") != std::string::npos;
}

}  // namespace

std::string notes_for(const std::string& text, const std::string& kernel) {
  static const std::string mark = "/*? ", end = " */ ";
  std::string out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (starts_with(line, mark)) {
      const bool without = line[mark.size()] == '!';
      const std::size_t name = mark.size() + (without ? 1 : 0), after = line.find(end, name);
      if (defines(kernel, line.substr(name, after - name)) == without) continue;
      line.erase(0, after + end.size());
    }
    out += line + "\n";
  }
  return out;
}

void read_notes(const std::string& text, const std::string& prefix, Notes& notes) {
  Function* function = nullptr;
  Lines* lines = nullptr;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    line = prefixed(line, prefix);
    if (line.empty() || line[0] == '#') continue;
    if (starts_with(line, "== after ")) {
      lines = &notes.after[line.substr(9)];
    } else if (starts_with(line, "== ")) {
      function = &notes.functions[line.substr(3)];
      lines = &function->contract;
    } else if (function != nullptr && starts_with(line, "!! ")) {
      function->held = line.substr(3);
    } else if (function != nullptr && starts_with(line, "-- loop ")) {
      lines = &function->loops[std::stoi(line.substr(8))];
    } else if (function != nullptr && starts_with(line, "-- before ")) {
      lines = &function->before.emplace_back(line.substr(10), Lines()).second;
    } else if (function != nullptr && line == "-- at end") {
      lines = &function->at_end;
    } else if (lines != nullptr) {
      lines->push_back(line);
    }
  }
}

}  // namespace rtac::contract
