#include "compiler/driver/options.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <map>
#include <system_error>
#include <utility>

#include "compiler/codegen/mutate.h"
#include "compiler/codegen/names.h"
#include "compiler/passes/pipeline.h"

namespace rtac::driver {
namespace {

bool is_namespace(const std::string& text) {
  if (text.empty() || codegen::legal_namespace(text) != text) return false;
  if (std::isdigit(static_cast<unsigned char>(text[0]))) return false;
  for (const char c : text) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
  }
  return true;
}

std::string pass_names() {
  std::string names;
  for (const auto& pass : passes::pipeline()) {
    names += std::string(names.empty() ? "`" : ", `") + pass.name + "`";
  }
  return names;
}

bool is_pass(const std::string& name) {
  const auto& all = passes::pipeline();
  return std::any_of(all.begin(), all.end(), [&](const auto& pass) { return name == pass.name; });
}

// `picture`: `-o` names the file of a picture.
std::string value_hint(const std::string& flag, bool picture = false) {
  if (flag == "--format") return "`text`, `json` and `sarif` exist";
  if (flag == "--engine") return "`kernel` and `interp` exist";
  if (flag == "--print-after") return "there are " + pass_names();
  if (flag == "--namespace" || flag == "--monitor") return "`" + flag + " NAME`";
  if (flag == "--max-bytes") return "`--max-bytes 4096`";
  if (flag == "--mutate") return "`--mutate half-look-ahead`";
  if (flag == "--seed") return "`--seed 7`";
  if (flag == "--runs") return "`--runs 1000`";
  if (flag == "--jobs") return "`--jobs 4`";
  if (flag == "--simulate") return "`--simulate 20`";
  if (flag == "--attack") return "`--attack 60`";
  if (flag == "--adversary") return "`--adversary chase-fence`";
  if (flag == "--in") return "`--in main.rta`";
  const bool folder = (flag == "-o" && !picture) || flag == "--recheck";
  return "`" + flag + (folder ? " DIR`" : " FILE`");
}

bool asks_for_help(const std::string& word) {
  return word == "--help" || word == "-h";
}

struct CommandInfo {
  const char* name;
  Command command;
  std::vector<std::string> flags;
  std::size_t operands_max;
};
const std::vector<CommandInfo>& commands() {
  constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();
  static const std::vector<CommandInfo> all = {
      {"check",
       Command::check,
       {"-o", "--depfile", "--namespace", "--print-after", "--format", "--dump-ast", "--dump-spec",
        "--dump-ir", "-Werror", "--max-bytes"},
       1},
      {"build",
       Command::build,
       {"-o", "--depfile", "--namespace", "--mutate", "--contracts", "--print-after", "--format",
        "--dump-ast", "--dump-spec", "--dump-ir", "-Werror", "--max-bytes"},
       1},
      {"replay",
       Command::replay,
       {"--engine", "--monitor", "--format", "-Werror", "--max-bytes"},
       2},
      {"sim",
       Command::sim,
       {"--scenario", "--seed", "--runs", "--jobs", "--adversary", "--trace", "--replay",
        "--mutate", "--format", "-Werror"},
       1},
      {"verify",
       Command::verify,
       {"-o", "--recheck", "--conservatism", "--attack", "--mutate", "--format", "-Werror"},
       1},
      {"zones", Command::zones, {"-o", "--format", "-Werror", "--max-bytes"}, 1},
      {"protocol", Command::protocol, {"-o", "--format", "-Werror", "--max-bytes"}, 1},
      {"fmt", Command::format, {"--check", "--format"}, any_number},
      {"explain", Command::explain, {"--in", "--simulate"}, 1},
  };
  return all;
}
std::string command_names() {
  std::string names;
  for (const CommandInfo& info : commands()) names += std::string("`") + info.name + "`, ";
  return names + "`help` and `version`";
}

struct Parser {
  explicit Parser(const CommandInfo& c) : info(c) { options.command = c.command; }
  const CommandInfo& info;
  Options options;
  UsageError problem;
  std::vector<std::string> operands;
  std::string format, engine, bytes_max, importer;

  // Flags that take the next word.
  std::map<std::string, std::string*> with_value() {
    return {{"-o", &options.output},
            {"--depfile", &options.depfile},
            {"--namespace", &options.name_space},
            {"--print-after", &options.print_after},
            {"--format", &format},
            {"--engine", &engine},
            {"--monitor", &options.monitor},
            {"--max-bytes", &bytes_max},
            {"--scenario", &options.scenario},
            {"--seed", &options.seed},
            {"--runs", &options.runs},
            {"--jobs", &options.jobs},
            {"--adversary", &options.adversary},
            {"--trace", &options.trace_out},
            {"--replay", &options.recorded},
            {"--in", &importer},
            {"--simulate", &options.simulated},
            {"--recheck", &options.recheck},
            {"--attack", &options.attack_s},
            {"--mutate", &options.mutant}};
  }
  std::map<std::string, bool*> switches() {
    return {{"--dump-ast", &options.dump_ast},
            {"--dump-spec", &options.dump_spec},
            {"--dump-ir", &options.dump_ir},
            {"--check", &options.only_check},
            {"--conservatism", &options.conservatism},
            {"--contracts", &options.contracts},
            {"-Werror", &options.werror}};
  }

  void parse(const std::vector<std::string>& words) {
    const auto values = with_value();
    const auto flags = switches();
    bool only_operands = false;
    for (std::size_t i = 1; i < words.size() && problem.message.empty(); ++i) {
      const std::string& word = words[i];
      if (only_operands || word == "-" || word[0] != '-') {
        operand(word);
      } else if (word == "--") {
        only_operands = true;
      } else if (!values.count(word) && !flags.count(word)) {
        problem = {"unknown flag `" + word + "`",
                   "`rtac help " + std::string(info.name) + "` lists the flags"};
      } else if (std::find(info.flags.begin(), info.flags.end(), word) == info.flags.end()) {
        problem = {"`rtac " + std::string(info.name) + "` has no flag `" + word + "`",
                   "`rtac help " + std::string(info.name) + "` lists the flags"};
      } else if (const auto value = values.find(word); value != values.end()) {
        take(word, i + 1 < words.size() ? words[++i] : "", *value->second);
      } else {
        *flags.at(word) = true;
      }
    }
  }
  // `--runs -3`: a number that is wrong, and no flag.
  static bool is_below_zero(const std::string& flag, const std::string& value) {
    constexpr std::string_view flags[] = {"--max-bytes", "--seed",     "--runs",
                                          "--jobs",      "--simulate", "--attack"};
    return std::ranges::find(flags, flag) != std::end(flags) && value.size() > 1 &&
           std::isdigit(static_cast<unsigned char>(value[1])) != 0;
  }
  // A second value of a flag would silently win over the first.
  void take(const std::string& flag, const std::string& value, std::string& place) {
    const bool picture = options.command == Command::zones;
    const bool is_stream = value == "-" && ((picture && flag == "-o") || flag == "--in");
    if (value.empty()) {
      problem = {"`" + flag + "` needs a value after it", value_hint(flag, picture)};
    } else if (value[0] == '-' && !is_below_zero(flag, value) && !is_stream) {
      problem = {"`" + flag + "` needs a value after it, not the flag `" + value + "`",
                 "a path that starts with a dash is written `./" + value + "`"};
    } else if (!place.empty()) {
      problem = {"`" + flag + "` is given twice: `" + place + "` and `" + value + "`",
                 "leave one of them out"};
    } else {
      place = value;
    }
  }
  void operand(const std::string& word) {
    if (word.empty()) {
      problem = {"the name of " + what(operands.size()) + " is empty", "give the path of a file"};
    } else if (operands.size() == info.operands_max) {
      problem = {"more than one " + kind(operands.size() - 1) + ": `" + operands.back() +
                     "` and `" + word + "`",
                 "run `rtac` once for each"};
    } else {
      operands.push_back(word);
    }
  }
  // What the operand at this place is.
  std::string kind(std::size_t place) const {
    if (options.command == Command::explain) return "diagnostic or line";
    return options.command == Command::replay && place == 1 ? "trace" : "specification";
  }
  std::string what(std::size_t place) const { return "the " + kind(place); }

  void choose() {
    if (format == "json") {
      options.format = Format::json;
    } else if (format == "sarif") {
      options.format = Format::sarif;
    } else if (!format.empty() && format != "text") {
      problem = {"unknown format `" + format + "`", value_hint("--format")};
    }
    if (engine == "interp") {
      options.engine = EngineKind::interp;
    } else if (!engine.empty() && engine != "kernel") {
      problem = {"unknown engine `" + engine + "`", value_hint("--engine")};
    }
    number(options.seed, "--seed");
    number(options.runs, "--runs");
    number(options.jobs, "--jobs");
    number(options.simulated, "--simulate");
    number(options.attack_s, "--attack");
    if (bytes_max.empty()) return;
    std::uint64_t bytes = 0;
    const char* const end = bytes_max.data() + bytes_max.size();
    const auto [stop, error] = std::from_chars(bytes_max.data(), end, bytes);
    if (error != std::errc() || stop != end) {
      problem = {"`" + bytes_max + "` is no number of bytes", value_hint("--max-bytes")};
    }
    options.state_bytes_max = bytes;
  }
  // Of 64 bits.
  void number(const std::string& text, const std::string& flag) {
    if (text.empty()) return;
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool simulates = flag == "--runs" || flag == "--simulate" || flag == "--attack";
    if (error != std::errc() || stop != end) {
      problem = {"`" + text + "` is no number for `" + flag + "`", value_hint(flag)};
    } else if (simulates && value == 0) {
      problem = {"`" + flag + " " + text + "` simulates nothing", "`" + flag + " 1` works"};
    }
  }
  // Certificates come with their specification.
  bool brings_its_own() {
    if (options.recheck.empty()) return false;
    if (!operands.empty()) {
      problem = {"`--recheck` takes the specification from `" + options.recheck + "`, and `" +
                     operands[0] + "` is given",
                 "leave one of them out"};
    }
    const std::pair<const char*, bool> others[] = {{"-o", !options.output.empty()},
                                                   {"--attack", !options.attack_s.empty()},
                                                   {"--conservatism", options.conservatism}};
    for (const auto& [flag, given] : others) {
      if (!given) continue;
      problem = {
          std::string("`--recheck` writes and measures nothing, and `") + flag + "` is given",
          "leave one of them out"};
    }
    return true;
  }
  void take_operands() {
    if (brings_its_own()) return;
    const std::size_t due = options.command == Command::replay ? 2 : 1;
    if (operands.size() < due) {
      const std::size_t place = operands.size();
      problem = {"no " + kind(place) + " is given", place_hint(place)};
      return;
    }
    switch (options.command) {
      case Command::explain:
        if (!take_place(operands[0])) take_topic(operands[0]);
        break;
      case Command::format:
        options.files = operands;
        break;
      case Command::replay:
        options.trace = operands[1];
        [[fallthrough]];
      case Command::check:
      case Command::build:
      case Command::sim:
      case Command::verify:
      case Command::zones:
      case Command::protocol:
      case Command::help:
      case Command::version:
        options.spec = operands[0];
        break;
    }
    if (options.command == Command::replay && options.spec == "-" && options.trace == "-") {
      problem = {"specification and trace cannot both come from standard input",
                 "give the path of one of them"};
    }
  }
  void take_topic(const std::string& text) {
    constexpr std::string_view ending = ".rta";
    options.topic = text;
    const bool is_file = text.size() > ending.size() &&
                         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
    if (!is_file) return;
    problem = {"`" + text + "` is a file, without a line",
               "give FILE:LINE, such as `" + text + ":1`"};
  }
  // `FILE:LINE`, or `FILE:LINE:COLUMN` as messages have it.
  bool take_place(std::string text) {
    std::string last = cut_number(text);
    if (last.empty()) return false;
    if (std::string line = cut_number(text); !line.empty()) last = std::move(line);
    options.spec = text;
    options.line = last;
    if (importer.empty()) return true;
    options.part = text;
    options.spec = importer;
    return true;
  }
  // Cuts `:12` off the end, when there is something before it; empty: there is no such end.
  static std::string cut_number(std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) return "";
    std::string digits = text.substr(colon + 1);
    if (!std::all_of(digits.begin(), digits.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; })) {
      return "";
    }
    text.resize(colon);
    return digits;
  }
  std::string place_hint(std::size_t place) const {
    if (options.command == Command::explain) {
      return "give the number of a diagnostic, such as 3001, or its name, or FILE:LINE";
    }
    return place == 0 ? "give the path of a .rta file, or - for standard input"
                      : "give the path of a .csv file, or - for standard input";
  }
  // What a recorded run says itself.
  void refuse_with_recorded() {
    const std::pair<const char*, const std::string*> others[] = {
        {"--scenario", &options.scenario},
        {"--seed", &options.seed},
        {"--runs", &options.runs},
        {"--jobs", &options.jobs},
        {"--adversary", &options.adversary}};
    for (const auto& [flag, value] : others) {
      if (value->empty()) continue;
      problem = {
          std::string("`--replay` plays one recorded run, and `") + flag + "` asks for others",
          "leave one of them out"};
    }
  }
  void finish() {
    if (problem.message.empty()) choose();
    if (problem.message.empty()) take_operands();
    if (!problem.message.empty()) return;
    if (options.command == Command::build && options.output.empty()) {
      problem = {"`rtac build` needs a place for the generated files", "add `-o DIR`"};
    }
    if (!options.recorded.empty()) refuse_with_recorded();
    if (!options.simulated.empty() && options.line.empty()) {
      problem = {"`--simulate` tells of a specification, and `" + options.topic + "` is none",
                 "give FILE:LINE, such as the line of a monitor"};
    }
    if (!importer.empty() && options.line.empty()) {
      problem = {
          "`--in` names what imports the file of a line, and `" + options.topic + "` is none",
          "give FILE:LINE, such as `imported.rta:2`"};
    }
    if (options.command == Command::zones && options.output.empty()) {
      problem = {"`rtac zones` needs a place for the picture",
                 "add `-o zones.svg`, or `-o -` for standard output"};
    }
    if (options.command == Command::protocol && options.output.empty()) {
      problem = {"`rtac protocol` needs a place for the models", "add `-o DIR`"};
    }
    if (options.command == Command::check && !(options.output + options.depfile).empty()) {
      problem = {"`rtac check` writes no files",
                 "leave out `-o` and `--depfile`, or use `rtac build`"};
    }
    if (!options.name_space.empty() && !is_namespace(options.name_space)) {
      problem = {
          "`" + options.name_space + "` cannot be the namespace of generated code",
          "one word of letters, digits and `_` can that begins with a letter; no keyword, no name "
          "of the C library, nor `std` or `rtac`"};
    }
    if (options.command == Command::verify && !options.mutant.empty() && !options.conservatism) {
      problem = {"what `rtac verify` proves of a specification is not true of its mutants",
                 "`--conservatism --mutate NAME` measures one"};
    }
    if (!options.mutant.empty() && codegen::find_mutant(options.mutant) == nullptr) {
      problem = {"no mutant is called `" + options.mutant + "`",
                 "there are " + codegen::mutant_names()};
    }
    if (!options.print_after.empty() && !is_pass(options.print_after)) {
      problem = {"no pass is called `" + options.print_after + "`", "there are " + pass_names()};
    }
  }
};

// `--name=value` is two words, except behind `--`.
std::vector<std::string> split_equals(const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  bool only_operands = false;
  for (const std::string& a : arguments) {
    only_operands = only_operands || a == "--";
    const std::size_t equals = a.find('=');
    if (!only_operands && a.rfind("--", 0) == 0 && equals != std::string::npos) {
      words.push_back(a.substr(0, equals));
      words.push_back(a.substr(equals + 1));
    } else {
      words.push_back(a);
    }
  }
  return words;
}

std::variant<Options, UsageError> help_about(const std::vector<std::string>& words) {
  Options options;
  if (words.size() < 2) return options;
  const auto& all = commands();
  const auto info = std::find_if(all.begin(), all.end(),
                                 [&](const CommandInfo& c) { return words[1] == c.name; });
  if (info == all.end()) {
    if (words[1] == "help" || words[1] == "version" || words[1] == "--version") return options;
    return UsageError{"unknown command `" + words[1] + "`", "there are " + command_names()};
  }
  options.topic = info->name;
  options.help_flags = info->flags;
  // `check` knows these in order to say that it writes nothing
  if (info->command == Command::check) {
    std::erase_if(options.help_flags,
                  [](const std::string& flag) { return flag == "-o" || flag == "--depfile"; });
  }
  return options;
}

}  // namespace

std::variant<Options, UsageError> parse_options(const std::vector<std::string>& arguments) {
  const std::vector<std::string> words = split_equals(arguments);
  if (words.empty()) {
    return UsageError{"no command is given",
                      "`rtac check SPEC`, `rtac build SPEC -o DIR`, `rtac help`"};
  }
  const auto operands = std::find(words.begin(), words.end(), "--");
  const bool asked = std::any_of(words.begin(), operands, asks_for_help);
  if (words[0] == "help" || asks_for_help(words[0])) return help_about(words);
  if (asked) return help_about({"help", words[0]});
  if (words[0] == "--version" || words[0] == "version") {
    if (words.size() > 1) {
      return UsageError{"`" + words[0] + "` takes nothing after it", "`rtac " + words[0] + "`"};
    }
    Options options;
    options.command = Command::version;
    return options;
  }
  const auto& all = commands();
  const auto info = std::find_if(all.begin(), all.end(),
                                 [&](const CommandInfo& c) { return words[0] == c.name; });
  if (info == all.end()) {
    return UsageError{"unknown command `" + words[0] + "`", "there are " + command_names()};
  }
  Parser parser(*info);
  parser.parse(words);
  parser.finish();
  if (!parser.problem.message.empty()) return parser.problem;
  return parser.options;
}

}  // namespace rtac::driver
