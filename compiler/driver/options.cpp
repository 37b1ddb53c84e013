#include "compiler/driver/options.h"

#include <cctype>
#include <cstdlib>
#include <map>

#include "compiler/codegen/names.h"
#include "compiler/passes/pipeline.h"

namespace rtac::driver {
namespace {

bool is_namespace(const std::string& text) {
  if (text.empty() || codegen::legal(text) != text) return false;
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

// Flags that take the next word.
struct Parser {
  Options options;
  UsageError problem;

  std::map<std::string, std::string*> with_value() {
    return {{"-o", &options.output},
            {"--depfile", &options.depfile},
            {"--namespace", &options.name_space},
            {"--print-after", &options.print_after}};
  }
  std::map<std::string, bool*> switches() {
    return {{"--dump-ast", &options.dump_ast},
            {"--dump-spec", &options.dump_spec},
            {"--dump-ir", &options.dump_ir},
            {"-Werror", &options.werror}};
  }

  // `name=value` is split into two words first, so both forms work.
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
      } else if (const auto value = values.find(word); value != values.end()) {
        if (i + 1 == words.size()) {
          problem = {"`" + word + "` needs a value after it", "`" + word + " VALUE`"};
        } else {
          *value->second = words[++i];
        }
      } else if (const auto flag = flags.find(word); flag != flags.end()) {
        *flag->second = true;
      } else if (word == "--format") {
        format(i + 1 < words.size() ? words[++i] : "");
      } else {
        problem = {"unknown flag `" + word + "`", "`rtac help` lists the flags"};
      }
    }
  }
  void operand(const std::string& word) {
    if (word.empty()) {
      problem = {"the name of the specification is empty", "give the path of a .rta file"};
    } else if (!options.spec.empty()) {
      problem = {"more than one specification: `" + options.spec + "` and `" + word + "`",
                 "run `rtac` once for each"};
    } else {
      options.spec = word;
    }
  }
  void format(const std::string& name) {
    if (name == "text") {
      options.format = Format::text;
    } else if (name == "json") {
      options.format = Format::json;
    } else {
      problem = {
          name.empty() ? "`--format` needs a value after it" : "unknown format `" + name + "`",
          "`text` and `json` exist"};
    }
  }
  void finish() {
    if (!problem.message.empty()) return;
    if (options.spec.empty()) {
      problem = {"no specification is given",
                 "give the path of a .rta file, or - for standard input"};
    }
    if (options.command == Command::build && options.output.empty()) {
      problem = {"`rtac build` needs a place for the generated files", "add `-o DIR`"};
    }
    if (options.command == Command::check && !(options.output + options.depfile).empty()) {
      problem = {"`rtac check` writes no files",
                 "leave out `-o` and `--depfile`, or use `rtac build`"};
    }
    if (!options.name_space.empty() && !is_namespace(options.name_space)) {
      problem = {"`" + options.name_space + "` is not a name of a C++ namespace",
                 "letters, digits and `_` make one, and it is no keyword"};
    }
    if (!options.print_after.empty()) {
      bool known = false;
      for (const auto& pass : passes::pipeline()) known = known || options.print_after == pass.name;
      if (!known) {
        problem = {"no pass is called `" + options.print_after + "`", "there are " + pass_names()};
      }
    }
  }
};

std::vector<std::string> split_equals(const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  for (const std::string& a : arguments) {
    const std::size_t equals = a.find('=');
    if (a.rfind("--", 0) == 0 && equals != std::string::npos) {
      words.push_back(a.substr(0, equals));
      words.push_back(a.substr(equals + 1));
    } else {
      words.push_back(a);
    }
  }
  return words;
}

}  // namespace

std::variant<Options, UsageError> parse_options(const std::vector<std::string>& arguments) {
  const std::vector<std::string> words = split_equals(arguments);
  Parser parser;
  if (words.empty()) {
    return UsageError{"no command is given",
                      "`rtac check SPEC`, `rtac build SPEC -o DIR`, `rtac help`"};
  }
  if (words[0] == "help" || words[0] == "--help" || words[0] == "-h") return parser.options;
  if (words[0] == "--version" || words[0] == "version") {
    parser.options.command = Command::version;
    return parser.options;
  }
  if (words[0] == "check") {
    parser.options.command = Command::check;
  } else if (words[0] == "build") {
    parser.options.command = Command::build;
  } else {
    return UsageError{"unknown command `" + words[0] + "`",
                      "there are `check`, `build`, `help` and `version`"};
  }
  parser.parse(words);
  parser.finish();
  if (!parser.problem.message.empty()) return parser.problem;
  return parser.options;
}

std::string help_text() {
  return "rtac: compiles a page of specification into decision modules for robots\n"
         "\n"
         "  rtac check SPEC              check, and print what was derived\n"
         "  rtac build SPEC -o DIR       write the modules and the runtime of the system\n"
         "  rtac help | version\n"
         "\n"
         "SPEC is the path of a .rta file, or - for standard input.\n"
         "\n"
         "  --format text|json           form of the diagnostics (stderr)\n"
         "  --namespace NAME             C++ namespace of the generated code\n"
         "  --depfile FILE               write the dependencies for make or ninja\n"
         "  -Werror                      warnings count as errors\n"
         "  --dump-ast --dump-spec --dump-ir\n"
         "                               print the tree, the checked specification, the decision "
         "IR\n"
         "  --print-after PASS           print the IR after that pass\n"
         "\n"
         "Exit codes: 0 clean, 1 the specification has errors, 2 usage, 70 internal error.\n";
}

}  // namespace rtac::driver
