// Puts contracts where they belong in the text of a kernel, which is printed in one layout: a
// declaration begins in the first column, a function ends with a `}` there.
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "compiler/contract/contract.h"
#include "compiler/contract/notes.h"
#include "compiler/contract/texts.h"

namespace rtac::contract {
namespace {

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}
bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
std::size_t indent_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// Name of the function whose head begins in this line; empty: none does.
std::string function_in(const std::string& line) {
  const bool is_head =
      starts_with(line, "static ") || starts_with(line, "void ") || starts_with(line, "int64_t ");
  const std::size_t open = line.find('(');
  if (!is_head || open == std::string::npos || line.find('=') < open) return "";
  const std::size_t begin = line.find_last_of(" *", open) + 1;
  return line.substr(begin, open - begin);
}

// Name of what is declared whole by the end of this line.
std::string declared_in(const std::string& line) {
  if (starts_with(line, "} ") && ends_with(line, ";")) return line.substr(2, line.size() - 3);
  std::istringstream words(line);
  std::string first, name;
  words >> first >> name;
  if (first == "#define") return name;
  const std::size_t equals = line.find(" = ");
  if (!starts_with(line, "static const ") || equals == std::string::npos) return "";
  if (!ends_with(line, ";")) return "";
  const std::string head = line.substr(0, equals);
  return head.substr(head.find_last_of(' ') + 1);
}

class Weaver {
 public:
  // `required`: what the notes of decisions are about; those of the library may be unused.
  Weaver(const Notes& notes, const Notes& required, const std::string& kernel) : notes_(notes) {
    for (const auto& [name, function] : required.functions) required_.insert(name);
    for (const auto& [name, lines] : required.after) required_.insert(name);
    std::istringstream in(kernel);
    for (std::string line; std::getline(in, line);) lines_.push_back(line);
  }

  Annotated run() {
    while (at_ < lines_.size()) {
      if (!take_function() && !take_table()) take_line();
    }
    for (const std::string& name : required_) {
      result_.missing.push_back("there is no function or declaration " + name);
    }
    return std::move(result_);
  }

 private:
  void put(const std::string& line) { result_.text += line + "\n"; }
  void put_comment(const Lines& lines, std::size_t indent = 0) {
    const std::string blank(indent, ' ');
    for (std::size_t i = 0; i < lines.size(); ++i) {
      put(blank + (i == 0 ? "/*@ " : "  @ ") + lines[i]);
    }
    if (!lines.empty()) put(blank + "  @*/");
  }
  // Each assertion is a comment of its own; one that goes on in the next line is indented there.
  void put_assertions(const Lines& lines, std::size_t indent) {
    Lines one;
    for (const std::string& line : lines) {
      if (line[0] != ' ') {
        put_comment(one, indent);
        one.clear();
      }
      one.push_back(line);
    }
    put_comment(one, indent);
  }

  bool take_function() {
    const std::string name = function_in(lines_[at_]);
    if (name.empty()) return false;
    std::size_t body = at_;
    while (!ends_with(lines_[body], "{") && !ends_with(lines_[body], ";")) ++body;
    if (ends_with(lines_[body], ";")) return false;
    const auto found = notes_.functions.find(name);
    if (found == notes_.functions.end()) {
      result_.missing.push_back("function " + name + " has no contract");
      take_body(body, nullptr, name);
      return true;
    }
    required_.erase(name);
    if (!found->second.held.empty()) put("/* held: " + name + ": " + found->second.held + " */");
    put_comment(found->second.contract);
    take_body(body, &found->second, name);
    return true;
  }

  void take_body(std::size_t body, const Function* function, const std::string& name) {
    for (; at_ <= body; ++at_) put(lines_[at_]);
    int loops = 0;
    std::set<std::size_t> done;
    for (; lines_[at_] != "}"; ++at_) {
      const std::size_t indent = indent_of(lines_[at_]);
      const std::string line = lines_[at_].substr(indent);
      for (std::size_t i = 0; function != nullptr && i < function->before.size(); ++i) {
        if (starts_with(line, function->before[i].first) && done.insert(i).second) {
          put_assertions(function->before[i].second, indent);
        }
      }
      if (starts_with(line, "for (")) put_loop(++loops, function, name, indent);
      put(lines_[at_]);
    }
    if (function != nullptr) put_assertions(function->at_end, 2);
    if (function != nullptr && done.size() < function->before.size()) {
      result_.missing.push_back("assertions of " + name + " have no place");
    }
  }
  void put_loop(int number, const Function* function, const std::string& name, std::size_t indent) {
    if (function == nullptr || !function->held.empty()) return;
    const auto found = function->loops.find(number);
    if (found != function->loops.end()) return put_comment(found->second, indent);
    result_.missing.push_back("loop " + std::to_string(number) + " of " + name +
                              " has no invariant");
  }

  // Of numbers that no proof looks at: `static const edge zone_free_edges[] = {` ... `};`
  bool take_table() {
    static const std::string mark = "[] = {";
    const std::string& line = lines_[at_];
    if (!ends_with(line, mark)) return false;
    const bool edges = starts_with(line, "static const edge ");
    if (!edges && !starts_with(line, "static const uint32_t ") &&
        !starts_with(line, "static const int32_t ")) {
      return false;
    }
    const std::string head = line.substr(7, line.size() - 7 - mark.size());
    std::size_t count = 0;
    for (++at_; lines_[at_] != "};"; ++at_) count += items_in(lines_[at_], edges);
    ++at_;
    put("extern " + head + "[" + std::to_string(count) + "];");
    return true;
  }
  // Edges are in braces; numbers end with a comma, but for the last one.
  std::size_t items_in(const std::string& line, bool edges) const {
    std::size_t count = 0;
    const std::string bare = line.substr(0, line.find("/*"));
    for (const char c : bare) count += c == (edges ? '{' : ',') ? 1 : 0;
    const std::size_t last = bare.find_last_not_of(' ');
    const bool ends_open = last != std::string::npos && bare[last] != ',';
    return count + (!edges && ends_open ? 1 : 0);
  }

  void take_line() {
    put(lines_[at_]);
    const auto found = notes_.after.find(declared_in(lines_[at_++]));
    if (found == notes_.after.end()) return;
    put_comment(found->second);
    required_.erase(found->first);
  }

  const Notes& notes_;
  std::vector<std::string> lines_;
  std::size_t at_ = 0;
  std::set<std::string> required_;  // and not found yet
  Annotated result_;
};

}  // namespace

Annotated annotate(const std::string& kernel, const std::string& prefix,
                   const std::string& contracts) {
  Notes notes, required;
  const std::string here = notes_for(contracts, kernel);
  // First, since what they require of functions of the library has to precede what those ensure.
  read_notes(here, prefix, notes);
  for (const char* text : library_texts()) read_notes(notes_for(text, kernel), prefix, notes);
  read_notes(here, prefix, required);
  return Weaver(notes, required, kernel).run();
}

}  // namespace rtac::contract
