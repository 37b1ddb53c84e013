#include "compiler/codegen/names.h"

#include <algorithm>
#include <cctype>

#include "compiler/codegen/kernel_library.h"
#include "compiler/codegen/library_names.h"
#include "compiler/codegen/watch.h"

namespace rtac::codegen {
namespace {

const std::set<std::string>& reserved() {
  static const std::set<std::string> words = {
      "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break",
      "case", "catch", "char", "char16_t", "char32_t", "class", "compl", "const", "const_cast",
      "constexpr", "continue", "decltype", "default", "delete", "do", "double", "dynamic_cast",
      "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto",
      "if", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq",
      "nullptr", "operator", "or", "or_eq", "private", "protected", "public", "register",
      "reinterpret_cast", "restrict", "return", "short", "signed", "sizeof", "static",
      "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local",
      "throw", "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using",
      "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq", "concept", "requires",
      "co_await", "co_return", "co_yield", "consteval", "constinit", "char8_t", "import", "module",
      // names of libraries, and macros of common headers
      "std", "rtac", "main", "errno", "assert", "NULL", "EOF", "stdin", "stdout", "stderr", "linux",
      "unix", "major", "minor", "signbit", "isnan", "isinf", "NAN", "INFINITY", "HUGE_VAL",
      "BIG_ENDIAN", "LITTLE_ENDIAN", "BYTE_ORDER", "RAND_MAX", "CLOCKS_PER_SEC", "TIME_UTC",
      "EXIT_SUCCESS", "EXIT_FAILURE", "M_E", "M_PI", "offsetof", "alloca"};
  return words;
}

// INT64_MAX, UINT8_C, SIZE_WIDTH: macros of <stdint.h>, which every generated file includes.
bool is_limit_macro(const std::string& name) {
  const std::size_t last = name.rfind('_');
  if (last == std::string::npos) return false;
  const std::string end = name.substr(last + 1);
  if (end != "MAX" && end != "MIN" && end != "C" && end != "WIDTH") return false;
  for (const char* family : {"INT", "UINT", "SIZE", "PTRDIFF", "SIG_ATOMIC", "WCHAR", "WINT"}) {
    if (name.rfind(family, 0) == 0) return true;
  }
  return false;
}

// int8_t, uint_fast16_t, uintptr_t: types of <stdint.h>; the others are those of <stddef.h>.
bool is_library_type(const std::string& name) {
  if (name.size() < 2 || name.compare(name.size() - 2, 2, "_t") != 0) return false;
  for (const char* other : {"size_t", "ptrdiff_t", "max_align_t", "nullptr_t"}) {
    if (name == other) return true;
  }
  std::string rest = name.substr(0, name.size() - 2);
  if (rest.rfind('u', 0) == 0) rest.erase(0, 1);
  if (rest.rfind("int", 0) != 0) return false;
  rest.erase(0, 3);
  for (const char* kind : {"_fast", "_least"}) {
    if (rest.rfind(kind, 0) == 0) rest.erase(0, std::string(kind).size());
  }
  for (const char* width : {"8", "16", "32", "64", "max", "ptr"}) {
    if (rest == width) return true;
  }
  return false;
}

// `_X` and `__` belong to the language and its libraries, anywhere (C99 7.1.3, C++17 [lex.name]).
std::string without_reserved_form(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (c == '_' && !out.empty() && out.back() == '_') out += 'u';
    out += c;
  }
  const bool begins = out.size() > 1 && out[0] == '_';
  return begins && std::isupper(static_cast<unsigned char>(out[1])) != 0 ? "u" + out : out;
}

std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::move(word));
      word.clear();
    }
  }
  return words;
}

}  // namespace

std::string legal(const std::string& name) {
  const bool taken = reserved().count(name) > 0 || is_limit_macro(name) || is_library_type(name);
  return taken ? name + "_" : without_reserved_form(name);
}

std::string legal_namespace(const std::string& name) {
  return is_library_global(name) ? name + "_" : legal(name);
}

std::string camel(const std::string& name) {
  // trailing `_` stay: they are what keeps names apart
  const std::size_t end = name.find_last_not_of('_') + 1;
  std::string out;
  bool start = true;
  for (const char c : name.substr(0, end)) {
    if (c == '_') {
      start = true;
      continue;
    }
    out += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    start = false;
  }
  if (out.empty() || std::isdigit(static_cast<unsigned char>(out[0])) != 0) out.insert(0, "_");
  return legal(out + name.substr(end));
}

std::string upper(const std::string& name) {
  std::string out;
  for (const char c : name) {
    out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

std::string word_of(const std::string& text) {
  std::string word;
  for (const char c : text) word += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) != 0) word.insert(0, "_");
  return legal(word);
}

std::string signal_word(const std::string& signal) {
  std::string word;
  for (const char c : signal) {
    if (c != ']') word += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return word;
}

// Scopes: k file of the kernel, h its header, w namespace of the wrapper, s system class, c its
// slots of robots, e slots of controllers, r its struct of one robot; H first words of enumerators,
// E whole enumerators. What an inner scope calls in an outer one is taken in both, so that no
// member hides it.
Names::Names(const ir::Module& module, const sema::Spec& spec) {
  for (const char* const text : kernel_texts()) {
    for (const std::string& word : words_of(text)) taken_.insert("k:" + word);
  }
  taken_.insert({"w:System",
                 "s:Controllers",
                 "s:Robot",
                 "s:robots",
                 "s:return_clearance_m",
                 "s:cruise_clearance_m",
                 "s:pass_gap_m",
                 "s:robot_name",
                 "s:robot_number",
                 "s:default_options",
                 "s:decision_of",
                 "s:run",
                 "s:setting",
                 "s:standing",
                 "s:parts",
                 "s:parts_",
                 "s:system_",
                 "s:controllers",
                 "s:options",
                 "s:observer",
                 "c:tasks",
                 "r:Robot",
                 "r:self",
                 "r:recovery",
                 "r:mode",
                 "r:setting",
                 "r:standing",
                 "e:planner",
                 "M:INPUT",
                 "w:Monitors",
                 "H:MONITORS",
                 "H:VERDICT",
                 "H:REASON",
                 "H:INPUT",
                 "H:GATE",
                 "H:UNIT",
                 "H:PLAN"});
  // Types that a member of these names would hide in the classes that mention them.
  for (const char* const member :
       {"Index", "count", "step", "verdicts", "reset", "info", "state_", "in_", "findings_",
        "verdicts_", "position", "velocity", "battery", "heading", "plan", "heard", "record_"}) {
    taken_.insert(std::string("t:") + member);
  }
  for (const char* const part : {"_view", "_blind", "_look", "_judge", "_evaluate"}) {
    if (module.watch) taken_.insert("k:" + module.name + part);
  }
  for (const sema::RobotKind& kind : spec.kinds) {
    claim(kind.name, [&](const std::string& id) {
      return std::vector<std::string>{"w:" + id + "_limits",     "w:limits_of_" + id,
                                      "w:" + id + "Controllers", "w:" + id + "System",
                                      "s:" + id + "_limits",     "s:" + id + "Controllers"};
    });
  }
  claim_tables(module);
  claim_robots(spec);
  claim_controllers(spec);
  claim_decisions(module);
  claim_monitors(module);
  for (const sema::Enumeration& enumeration : spec.enumerations) {
    claim(enumeration.name, [](const std::string& id) {
      return std::vector<std::string>{"w:" + id, "t:" + id};
    });
  }
  if (module.watch) claim_watch(module);
}

std::string Names::operator()(const std::string& name) const {
  const auto known = identifiers_.find(name);
  return known == identifiers_.end() ? legal(name) : known->second;
}

template <class Derived>
void Names::claim(const std::string& name, const Derived& derived) {
  std::string id = legal(name);
  const auto clashes = [&] {
    const std::vector<std::string> all = derived(id);
    return std::any_of(all.begin(), all.end(),
                       [&](const std::string& each) { return taken_.count(each) > 0; });
  };
  while (clashes()) id += "_";
  for (const std::string& each : derived(id)) taken_.insert(each);
  identifiers_.emplace(name, id);
}

void Names::claim_tables(const ir::Module& module) {
  for (const ir::Solid& solid : module.watch ? module.watch->solids : std::vector<ir::Solid>{}) {
    taken_.insert({"k:" + solid_symbol(solid), "k:" + solid_symbol(solid) + "_slabs"});
  }
  for (const ir::Region& region :
       module.watch ? module.watch->regions : std::vector<ir::Region>{}) {
    if (region.channel) continue;
    taken_.insert({"k:" + region_symbol(region), "k:" + region_symbol(region) + "_edges"});
  }
  for (const ir::Schedule* schedule : schedules_of(module)) {
    taken_.insert(
        {"k:" + schedule_symbol(*schedule), "k:" + schedule_symbol(*schedule) + "_openings"});
  }
  for (const ir::ZoneTable& zone : module.zones) {
    claim(zone.name, [&](const std::string& id) {
      return std::vector<std::string>{"k:zone_" + id,       "k:zone_" + id + "_edges",
                                      "w:" + id + "_zone",  "w:" + id + "_edges_mm",
                                      "w:" + id + "_rings", "w:" + id + "_clearance_mm",
                                      "s:" + id + "_zone",  "r:" + id + "_zone"};
    });
  }
  for (const ir::SiteTable& site : module.sites) {
    claim(site.name, [&](const std::string& id) {
      std::vector<std::string> all{"k:cells_to_" + id,
                                   "w:cost_to_" + id + "_ppm",
                                   "w:cost_to_" + id + "_table",
                                   "w:energy_to_" + id,
                                   "s:" + id,
                                   "r:" + id};
      for (const auto& place : site.places) {
        all.push_back("k:cost_to_" + id + "_" + word_of(place.robot));
      }
      return all;
    });
  }
}

void Names::claim_robots(const sema::Spec& spec) {
  const auto slots = [](const std::string& id) {
    return std::vector<std::string>{"c:" + id, "s:" + id + "_"};
  };
  for (const sema::Robot& robot : spec.robots) {
    if (!robot.number) {
      claim(robot.name, slots);
      continue;
    }
    // The members of a numbered fleet are elements of one array; tables of their own have a name.
    const std::string number = std::to_string(*robot.number);
    if (*robot.number == 0) claim(robot.fleet, slots);
    identifiers_.emplace(robot.name, (*this)(robot.fleet) + "_" + number);
  }
}

void Names::claim_controllers(const sema::Spec& spec) {
  for (const sema::Controller& controller : spec.controllers) {
    claim(controller.name, [&](const std::string& id) {
      return std::vector<std::string>{"e:" + id, "r:" + id, "r:external_" + id};
    });
  }
}

void Names::claim_decisions(const ir::Module& module) {
  for (const ir::Decision& decision : module.decisions) {
    claim(decision.name, [&](const std::string& id) {
      std::vector<std::string> all{"r:" + id,
                                   "r:" + id + "_module",
                                   "w:" + id + "_monitors",
                                   "w:" + id + "_info",
                                   "w:" + id + "_robots",
                                   "w:" + id + "_inputs",
                                   "w:" + id + "_units",
                                   "w:" + camel(id),
                                   "r:" + camel(id),
                                   "s:" + camel(id)};
      for (const char* const part :
           {"_body", "_heard_body", "_motions", "_horizons_us", "_view", "_look", "_measure",
            "_check", "_report", "_facts_view", "_facts_blind", "_facts_look", "_facts_catch_up",
            "_facts_judge"}) {
        all.push_back("k:" + id + part);
      }
      for (std::size_t k = 0; k < decision.facts.monitors.size(); ++k) {
        all.push_back("k:" + id + "_fact_" + std::to_string(k));
      }
      for (const char* const part :
           {"_in", "_state", "_out", "_init", "_step", "_judge", "_facts_in", "_facts_state"}) {
        all.push_back("h:" + id + part);
      }
      all.insert(all.end(),
                 {"H:" + upper(id), "E:" + upper(id) + "_MONITORS", "E:" + upper(id) + "_ROBOTS"});
      return all;
    });
  }
}

void Names::claim_monitors(const ir::Module& module) {
  for (const ir::Decision& decision : module.decisions) {
    const std::string owner = (*this)(decision.name);
    for (const ir::Monitor& monitor : decision.monitors) {
      if (identifiers_.count(monitor.name) > 0) continue;  // in two decisions of one kind
      claim(monitor.name, [&](const std::string& id) {
        std::vector<std::string> all{"E:" + upper(owner + "_" + id)};
        for (const char* const part : {"_now", "_ahead", "_return"}) {
          all.push_back("k:" + owner + "_" + id + part);
        }
        return all;
      });
    }
  }
}

void Names::claim_watch(const ir::Module& module) {
  for (const ir::PlainMonitor& monitor : module.watch->monitors) {
    claim(monitor.name, [&](const std::string& id) {
      return std::vector<std::string>{"k:" + id + "_now", "k:" + id + "_told",
                                      "k:" + id + "_closely", "M:" + upper(id)};
    });
  }
}

}  // namespace rtac::codegen
