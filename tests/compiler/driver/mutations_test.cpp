// A hostile session: thousands of damaged specifications. The compiler never crashes and never
// finds a bug in itself; it accepts, or names at least one error with its place.
#include <cctype>
#include <cstdlib>
#include <random>

#include "compiler/codegen/generate.h"
#include "compiler/driver/compile.h"
#include "tests/compiler/driver/testing.h"
#include "tests/turn.h"

namespace rtac::driver::test {
namespace {

std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const auto is_word = [&](std::size_t k) {
      return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) ||
                                 text[k] == '_' || text[k] == '.');
    };
    std::size_t end = i + 1;
    if (is_word(i)) {
      while (is_word(end)) ++end;
    } else if (text[i] == '"') {
      while (end < text.size() && text[end - (end > i + 1 ? 0 : 1)] != '\n' && text[end] != '"')
        ++end;
      end = std::min(end + 1, text.size());
    }
    tokens.push_back(text.substr(i, end - i));
    i = end;
  }
  return tokens;
}

class Mutator {
 public:
  Mutator(std::string text, unsigned seed) : tokens_(tokens_of(text)), random_(seed) {}

  std::string next() {
    std::vector<std::string> t = tokens_;
    const int edits = 1 + static_cast<int>(below(3));
    for (int i = 0; i < edits; ++i) edit(t);
    std::string text;
    for (const std::string& token : t) text += token;
    return text;
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }
  // Blanks are most of the tokens and change nothing.
  std::size_t place(const std::vector<std::string>& t) {
    std::size_t at = below(t.size());
    while (t[at] == " " || t[at] == "\n") at = (at + 1) % t.size();
    return at;
  }
  void edit(std::vector<std::string>& t) {
    static const std::vector<std::string> numbers = {
        "0", "1", "7", "0.001", "1e-9", "1e9", "1e30", "99999999999999999999", "0.3333333", "64"};
    static const std::vector<std::string> strays = {
        "(",    ")",       "{",      "}",    "[",       "]",        ";",       ",",
        ":",    "|",       "&",      "-",    "+",       "*",        "/",       ">=",
        "<=",   ">",       "not ",   "and ", "or ",     "forall ",  "exists ", "implies ",
        "for ", "inside ", "shrink", "grow", "circle ", "unsound ", "extern",  " m",
        " s",   " %",      "\"",     "\\",   "\x80",    "\x01",     "/*",      "//"};
    const std::size_t a = place(t), b = place(t);
    switch (below(9)) {
      case 0:
        t.erase(t.begin() + static_cast<std::ptrdiff_t>(a));
        break;
      case 1:
        t.insert(t.begin() + static_cast<std::ptrdiff_t>(a), t[b]);
        break;
      case 2:
        std::swap(t[a], t[b]);
        break;
      case 3:
        if (below(20) == 0) t.resize(a + 1);
        break;
      case 4:
      case 5:
      case 6:
        number(t, a, numbers[below(numbers.size())]);
        break;
      case 7:
        t[a] = strays[below(strays.size())];
        break;
      default:
        t[a] = t[b];
        break;
    }
    if (t.empty()) t.emplace_back(";");
  }
  // The next number from there on: most specifications stay well-formed this way.
  static void number(std::vector<std::string>& t, std::size_t from, const std::string& value) {
    for (std::size_t i = from; i < t.size(); ++i) {
      if (std::isdigit(static_cast<unsigned char>(t[i][0]))) {
        t[i] = value;
        return;
      }
    }
  }

  std::vector<std::string> tokens_;
  std::mt19937 random_;
};

// What a compilation must be, whatever the text.
std::string complaint(const Compilation& c) {
  if (!c.internal_error.empty()) return "internal error: " + c.internal_error;
  if (c.unreadable) return "unreadable";
  if (c.module.has_value() != !c.diagnostics.has_errors()) {
    return c.module ? "accepted in spite of errors" : "refused without an error";
  }
  for (const diag::Diagnostic& d : c.diagnostics.all()) {
    if (!d.range) return "an error without a place: " + d.message;
    if (d.range->end < d.range->begin || d.range->end > c.sources.text(d.range->file).size()) {
      return "an error beyond the text: " + d.message;
    }
  }
  return "";
}

// RTAC_MUTATIONS=20000 for a long session.
int count_of(int standard) {
  const char* const wanted = std::getenv("RTAC_MUTATIONS");
  return wanted ? std::atoi(wanted) : standard;
}

class Mutations : public InFolder, public ::testing::WithParamInterface<const char*> {};

TEST_P(Mutations, EveryDamagedTextIsAcceptedOrRefusedWithAPlace) {
  write("parts/drone.rta", spec_text("tests/golden/parts/drone.rta"));
  write("case/quadrotor.rta", spec_text("specs/drone_surveillance/quadrotor.rta"));
  const std::string name = GetParam();
  const std::string original = name.empty() ? drone_spec() : spec_text(name);
  Mutator mutator(original, 20240607);
  int tried = 0, accepted = 0;
  const int count = count_of(400);
  for (int i = 0; i < count; ++i) {
    const std::string text = i == 0 ? original : mutator.next();
    if (i > 0 && !rtac::test::is_due(static_cast<std::size_t>(i))) continue;
    ++tried;
    write("case/spec.rta", text);
    Options options;
    options.command = Command::check;
    options.spec = "case/spec.rta";
    std::ostringstream out;
    Compilation c;
    compile(options, out, c);
    const std::string problem = complaint(c);
    if (!problem.empty()) {
      FAIL() << problem << "\nmutation " << i << " of " << GetParam() << ":\n" << text;
    }
    if (!c.module) continue;
    ++accepted;
    EXPECT_FALSE(
        codegen::generate(std::move(*c.module), *c.spec, {"spec", "spec.rta", "", ""}).empty());
  }
  // a session in which nothing or everything is accepted would test one half only
  EXPECT_GT(accepted, tried / 50);
  EXPECT_LT(accepted, tried);
}

INSTANTIATE_TEST_SUITE_P(Specs, Mutations,
                         ::testing::Values("specs/robot_delivery/robot_delivery.rta",
                                           "specs/drone_surveillance/drone_surveillance.rta",
                                           "tests/golden/battery_floor/spec.rta",
                                           "tests/golden/or_of_zones/spec.rta", ""));

}  // namespace
}  // namespace rtac::driver::test
