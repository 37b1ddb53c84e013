#include "compiler/codegen/kernel_library.h"

#include <cctype>
#include <map>
#include <sstream>
#include <utility>

#include "compiler/codegen/names.h"

namespace rtac::codegen {
namespace {

struct Part {
  std::string name, kind, text;  // kind: one of the pairs below, or empty
  std::vector<std::string> needs;
};

// `/*= name : a b c */`
Part parse_head(const std::string& line) {
  Part part;
  std::istringstream words(line.substr(4, line.rfind("*/") - 4));
  std::string word;
  words >> part.name;
  while (words >> word) {
    if (word.front() == '@') {
      part.kind = word.substr(1);
    } else if (word != ":") {
      part.needs.push_back(word);
    }
  }
  return part;
}

// Functions of which there are two kinds, one where the first word is wanted, else the other one.
constexpr std::pair<const char*, const char*> kinds[] = {
    {"cells", "edges"}, {"in_space", "plane"}, {"agents_in_space", "agents_level"}};

std::vector<Part> parse_parts(const std::set<std::string>& wanted) {
  std::vector<Part> parts;
  for (const char* text : kernel_texts()) {
    std::istringstream lines(text);
    std::string line;
    bool in_part = false;  // what stands before the first part describes the file
    while (std::getline(lines, line)) {
      if (line.rfind("/*= ", 0) == 0) {
        parts.push_back(parse_head(line));
        in_part = true;
      } else if (in_part) {
        parts.back().text += line + "\n";
      }
    }
  }
  for (const auto& [with, without] : kinds) {
    const std::string other = wanted.count(with) > 0 ? without : with;
    std::erase_if(parts, [&](const Part& part) { return part.kind == other; });
  }
  return parts;
}

void need(const std::string& name, const std::map<std::string, const Part*>& by_name,
          std::set<std::string>& needed) {
  const auto part = by_name.find(name);
  if (part == by_name.end() || !needed.insert(name).second) return;
  for (const std::string& other : part->second->needs) need(other, by_name, needed);
}

// Lines that begin with `/*? name */` are there only when `name` is, those with `/*? !name */` only
// when it is not; the others always.
std::string with_options(const std::string& text, const std::set<std::string>& needed) {
  static const std::string mark = "/*? ";
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent != std::string::npos && line.compare(indent, mark.size(), mark) == 0) {
      const std::size_t name = indent + mark.size(), end = line.find(" */ ", name);
      const bool without = line[name] == '!';
      const std::size_t word = name + (without ? 1 : 0);
      if ((needed.count(line.substr(word, end - word)) == 0) != without) continue;
      line.erase(indent, end + 4 - indent);
    }
    out += line + "\n";
  }
  return out;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// KERNEL_point -> delivery_point; REASON_LEG -> DELIVERY_REASON_LEG
std::string prefixed(const std::string& text, const std::string& prefix) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_word(text[i])) {
      out += text[i++];
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string word = text.substr(i, end - i);
    if (word.rfind("KERNEL_", 0) == 0) {
      out += prefix + "_" + word.substr(7);
    } else {
      for (const char* family : {"REASON_", "INPUT_", "VERDICT_", "GATE_", "UNIT_"}) {
        if (word.rfind(family, 0) == 0) out += upper(prefix) + "_";
      }
      out += word;
    }
    i = end;
  }
  return out;
}

bool is_state_type(const std::string& name) {
  static const std::string end = "_state";
  return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

// Of what is needed, either the types of the state or all else.
std::string library(const std::set<std::string>& wanted, const std::string& prefix,
                    bool state_types) {
  const std::vector<Part> parts = parse_parts(wanted);
  std::map<std::string, const Part*> by_name;
  for (const Part& part : parts) by_name[part.name] = &part;
  std::set<std::string> needed;
  for (const std::string& name : wanted) need(name, by_name, needed);
  std::string out;
  for (const Part& part : parts) {
    if (needed.count(part.name) > 0 && is_state_type(part.name) == state_types) {
      out += prefixed(with_options(part.text, needed), prefix) + "\n";
    }
  }
  return out;
}

}  // namespace

std::string kernel_types(const std::set<std::string>& wanted, const std::string& prefix) {
  return library(wanted, prefix, true);
}
std::string kernel_library(const std::set<std::string>& wanted, const std::string& prefix) {
  return library(wanted, prefix, false);
}

}  // namespace rtac::codegen
