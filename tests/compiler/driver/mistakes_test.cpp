// What authors write by habit or by mistake, in mistakes.txt: each gives exactly one error, at its
// place, that says what works; and what its fix-it gives compiles.
#include <algorithm>
#include <cctype>
#include <optional>

#include "compiler/driver/compile.h"
#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

// In front of the cases of kind `property` and `items`.
constexpr const char* kDeclarations = R"(spec door;
period 100 ms;
enum Gear { park, drive }
input open, moving : bool;
input speed : real [m/s] in 0 .. 3 m/s;
input x : real [m] in 0 .. 9 m;
input n : int in 0 .. 10;
input gear : Gear;
input p, q : point in -5 .. 5 m;
input temps : real [K][4] in 200 K .. 400 K;
fun slow(v : real [m/s]) : bool = v <= 1 m/s;
param gap : length in 0.1 m .. 0.5 m = 0.2 m;
)";

// Behind the rovers of the documentation; cases of kind `robots` change a piece of all that.
constexpr const char* kMonitors = R"(
monitor apart for r : Rover {
  "SR-1: rovers keep 10 cm apart"
  always  forall q : Rover, q != r : distance(r, q) >= 10 cm;
  ahead   100 ms, 2 waypoints;
  recover give_way;
}
monitor fence for r : Rover {
  "SR-2: rovers stay in the yard"
  always  r inside yard;
  recover inwards;
  return  when clearance(r, yard) >= 5 cm for 1 s;
}
monitor charge for r : Rover {
  "SR-3: rovers come home"
  always  r.battery >= energy_to(home(r)) + 5 %;
  recover go_home;
}
decision drive for Rover {
  advanced explore;
  period   50 ms;
  priority apart > fence > charge;
  acknowledge give_way may break charge "held at most 30 s, which is in the price";
  acknowledge inwards  may break charge "less than the detour";
}
)";

struct Case {
  std::string name, text;
  int code = 0;
  std::string at, tells;    // the first line of the marked text, a part of what the report tells
  std::optional<int> then;  // the code that is left when the fix-it has been applied
};

// "=> 3001 `3` write `3 m` then 3004"
void read_expectation(const std::string& line, Case& each) {
  each.code = std::stoi(line.substr(3));
  const std::size_t open = line.find('`');
  const std::size_t close = line.find('`', open + 1);
  each.at = line.substr(open + 1, close - open - 1);
  each.tells = line.substr(std::min(close + 2, line.size()));
  const std::size_t then = each.tells.rfind(" then ");
  const bool has_code = then != std::string::npos && then + 6 < each.tells.size() &&
                        std::isdigit(static_cast<unsigned char>(each.tells[then + 6])) != 0;
  if (!has_code) return;  // `if c then a else b`
  each.then = std::stoi(each.tells.substr(then + 6));
  each.tells.resize(then);
}

// "- old" and "+ new", a piece of one line each.
std::string changed(std::string text, const std::string& body) {
  const std::size_t line_end = body.find('\n');
  const std::string from = body.substr(2, line_end - 2);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "not in the text: " + from;
  return text.replace(at, from.size(), body.substr(line_end + 3, body.size() - line_end - 4));
}

std::string whole_text(const std::string& kind, const std::string& body) {
  if (kind == "robots") {
    return changed("spec yard;\n" + spec_text("compiler/docs/examples/rovers.rta") + kMonitors,
                   body);
  }
  if (kind == "text") return body;
  if (kind == "fleet") {  // a property of a monitor without a robot, beside the rovers
    return "spec yard;\nperiod 100 ms;\nenum Gear { park, drive }\ninput gear : Gear;\n"
           "input q : bool;\ninput v : vector [m/s] in -3 .. 3 m/s;\n"
           "input p : point in -9 .. 9 m;\n" +
           spec_text("compiler/docs/examples/rovers.rta") + "monitor m { \"R1: x\" always " +
           body.substr(0, body.size() - 1) + "; }\n";
  }
  if (kind == "items") return kDeclarations + body;
  return kDeclarations + ("monitor m { \"R1: x\" always " + body.substr(0, body.size() - 1)) +
         "; }\n";
}

std::vector<Case> all_cases() {
  std::ifstream in(std::string(RTAC_SOURCE_DIR) + "/tests/compiler/driver/mistakes.txt");
  std::vector<Case> cases;
  std::string line, kind, body, name;
  while (std::getline(in, line)) {
    if (line.rfind("--- ", 0) == 0) {
      std::istringstream(line.substr(4)) >> kind >> name;
      body.clear();
    } else if (line.rfind("=> ", 0) == 0) {
      Case each;
      each.name = name;
      each.text = whole_text(kind, body);
      read_expectation(line, each);
      cases.push_back(std::move(each));
    } else {
      body += line + "\n";
    }
  }
  return cases;
}

class Mistakes : public InFolder {
 protected:
  static Compilation compiled(const std::string& text) {
    const std::string path = "mistake.rta";
    write(path, text);
    Options options;
    options.command = Command::check;
    options.spec = path;
    std::ostringstream out;
    Compilation c;
    compile(options, out, c);
    EXPECT_EQ(c.internal_error, "");
    return c;
  }
  static std::vector<diag::Diagnostic> errors_of(const Compilation& c) {
    std::vector<diag::Diagnostic> errors;
    for (const diag::Diagnostic& each : c.diagnostics.all()) {
      if (diag::info(each.code).severity == diag::Severity::error) errors.push_back(each);
    }
    return errors;
  }
  static std::string told(const std::vector<diag::Diagnostic>& errors) {
    std::string text;
    for (const diag::Diagnostic& each : errors) {
      text += std::to_string(static_cast<int>(each.code)) + " " + each.message + " [" + each.label +
              "] " + each.help + "\n";
    }
    return text;
  }
};

TEST_F(Mistakes, GiveOneErrorThatSaysWhatWorks) {
  for (const Case& each : all_cases()) {
    SCOPED_TRACE(each.name + ":\n" + each.text);
    const Compilation c = compiled(each.text);
    const auto errors = errors_of(c);
    EXPECT_EQ(errors.size(), 1U) << told(errors);
    if (errors.empty() || !errors.front().range) continue;
    const diag::Diagnostic& found = errors.front();
    EXPECT_EQ(static_cast<int>(found.code), each.code) << told(errors);
    const std::string marked(c.sources.text(*found.range));
    EXPECT_EQ(marked.substr(0, marked.find('\n')), each.at);
    EXPECT_NE(told(errors).find(each.tells), std::string::npos) << told(errors);
    EXPECT_FALSE(found.help.empty() && found.fixits.empty()) << told(errors);
  }
}

// The text with the fix-its of the report applied, the last place first.
std::string mended(std::string text, const diag::Diagnostic& report) {
  std::vector<diag::FixIt> fixits = report.fixits;
  std::sort(fixits.begin(), fixits.end(), [](const diag::FixIt& a, const diag::FixIt& b) {
    return a.range.begin > b.range.begin;
  });
  for (const diag::FixIt& fix : fixits) {
    text.replace(fix.range.begin, fix.range.end - fix.range.begin, fix.replacement);
  }
  return text;
}

TEST_F(Mistakes, AreMendedByTheirFixIt) {
  int fixed = 0;
  for (const Case& each : all_cases()) {
    const auto errors = errors_of(compiled(each.text));
    if (errors.empty() || errors.front().fixits.empty()) continue;
    const std::string text = mended(each.text, errors.front());
    SCOPED_TRACE(each.name + ":\n" + text);
    const auto left = errors_of(compiled(text));
    const int code = left.empty() ? 0 : static_cast<int>(left.front().code);
    EXPECT_EQ(code, each.then.value_or(0)) << told(left);
    ++fixed;
  }
  EXPECT_GE(fixed, 80);
}

TEST(MistakesFile, HasManyCases) {
  EXPECT_GE(all_cases().size(), 200U);
}

}  // namespace
}  // namespace rtac::driver::test
