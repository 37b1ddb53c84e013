// Every number in the help of an error of timing or arbitration (5xxx, 6xxx) is written into the
// specification: the error is gone. Five per cent beyond it, or a step of the grid, it is there
// again, or another one is that the offer mends as well. All faulty specifications of the goldens,
// of the refuted ones and of repairs/; a number that no row of the table knows is a failure.
#include <cmath>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "tests/compiler/analysis/testing.h"
#include "tests/slow.h"

namespace rtac::analysis::test {
namespace {

namespace fs = driver::test::fs;

// ---- texts --------------------------------------------------------------------------------------

const std::string number = "([0-9]+(?:\\.[0-9]+)?)";
const std::string quantity = "-?[0-9]+(?:\\.[0-9]+)? *[a-z%]+(?:/[a-z]+)?(?:\\^2)?";

// With what it imports in place of the imports, each once.
std::string whole(const fs::path& path, std::set<std::string>& seen) {
  std::string text = driver::test::read(path), all;
  const std::regex import("^import \"([^\"]+)\";.*");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); all += "\n") {
    std::smatch m;
    if (!std::regex_match(line, m, import)) {
      all += line;
    } else if (const fs::path other = fs::weakly_canonical(path.parent_path() / m[1].str());
               seen.insert(other.string()).second) {
      all += whole(other, seen);
    }
  }
  return all;
}

struct Span {
  std::size_t begin = std::string::npos, end = 0;
};
// A statement from its first word to the end: `;`, or the `}` of its block.
Span statement_at(const std::string& text, std::size_t begin) {
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (text[i] == '"') i = text.find('"', i + 1);
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return {begin, i + 1};
    if (text[i] == ';' && depth == 0) return {begin, i + 1};
  }
  return {begin, text.size()};
}
// The last statement of a kind that begins at or before `at`; of the whole text if none does.
Span statement_before(const std::string& text, const std::string& pattern, std::size_t at) {
  const std::regex re(pattern);
  Span found;
  for (std::sregex_iterator i(text.begin(), text.end(), re), end; i != end; ++i) {
    const auto begin = static_cast<std::size_t>(i->position());
    if (found.begin == std::string::npos || begin <= at) found = statement_at(text, begin);
  }
  return found;
}
std::string first_group(const std::string& text, const std::string& pattern) {
  std::smatch m;
  return std::regex_search(text, m, std::regex(pattern)) ? m[1].str() : "";
}
// The quantity after `pattern` within the span; nothing changes where there is none.
std::string with(const std::string& text, const Span& span, const std::string& pattern,
                 const std::string& value) {
  if (span.begin == std::string::npos) return text;
  const std::string part = text.substr(span.begin, span.end - span.begin);
  const std::regex re("(" + pattern + ")" + quantity);
  return text.substr(0, span.begin) +
         std::regex_replace(part, re, "$01" + value, std::regex_constants::format_first_only) +
         text.substr(span.end);
}

// ---- a finding ----------------------------------------------------------------------------------

struct Finding {
  int code = 0;
  std::size_t line = 0, begin = 0, end = 0;
  std::string message, help, notes;
};
std::vector<Finding> findings(const driver::Compilation& c, const std::string& text) {
  std::vector<Finding> all;
  for (const auto& d : c.diagnostics.all()) {
    if (!d.range) continue;
    const auto line = std::count(text.begin(), text.begin() + std::ptrdiff_t(d.range->begin), '\n');
    const std::string bare = std::regex_replace(d.message, std::regex("[0-9.]+"), "#");
    std::string notes;
    for (const diag::Note& n : d.notes) notes += n.text + "\n";
    all.push_back({static_cast<int>(d.code), static_cast<std::size_t>(line), d.range->begin,
                   d.range->end, bare, d.help, notes});
  }
  return all;
}

// The statements that a finding is about.
struct About {
  const std::string& text;
  const Finding& finding;

  [[nodiscard]] std::string kind() const {
    const std::string before = text.substr(0, text.find('\n', finding.begin));
    const std::regex re(
        "(?:monitor +\\w+ +for +\\w+ *: *|decision +\\w+ +for +|controller +\\w+ *: *\\w+ +for "
        "+|robot +)(\\w+)");
    std::string last;
    for (std::sregex_iterator i(before.begin(), before.end(), re), end; i != end; ++i) {
      last = (*i)[1];
    }
    return last;
  }
  [[nodiscard]] Span robot() const {
    return statement_before(text, "robot +" + kind() + "\\b", text.size());
  }
  [[nodiscard]] Span decision() const {
    return statement_before(text, "decision +\\w+ +for +" + kind() + "\\b", text.size());
  }
  [[nodiscard]] Span monitor() const {
    return statement_before(text, "monitor +\\w+", finding.begin);
  }
  // That the monitor recovers with, or that the finding stands at.
  [[nodiscard]] Span recovery() const {
    const Span m = monitor();
    std::string name = first_group(finding.message, "^the recovery `(\\w+)`");
    if (!name.empty()) {
      // named
    } else if (m.begin != std::string::npos && finding.begin >= m.begin && finding.begin < m.end) {
      name = first_group(text.substr(m.begin, m.end - m.begin), "recover +(\\w+)");
    } else {
      const std::size_t from = text.rfind('\n', finding.begin) + 1;
      name = first_group(text.substr(from, finding.end - from + 40), "controller +(\\w+)");
    }
    return statement_before(text, "controller +" + name + "\\b", text.size());
  }
  [[nodiscard]] Span itself() const { return {finding.begin, finding.end}; }
};

// ---- what is offered ----------------------------------------------------------------------------

// Which numbers fail again: larger or smaller ones, none, or the number itself.
enum class Beyond { more, less, nothing, itself };
struct Offer {
  std::string pattern;  // of the help; group 1: the number
  std::string unit;
  double grid;  // steps in the unit
  Beyond beyond;
  // The text with the number, or itself.
  std::function<std::string(const About&, const std::string& value)> apply;
  int code = 0;  // of this code alone
};

std::string in_every_monitor(const About& a, const std::string& value) {
  const double most = std::stod(value);
  std::string all, rest = a.text;
  const std::regex re("ahead +([0-9.]+) (m?s)");
  for (std::smatch m; std::regex_search(rest, m, re); rest = std::string(m.suffix())) {
    const double now = std::stod(m[1]) * (m[2] == "s" ? 1000 : 1);
    all += m.prefix().str() + (now > most ? "ahead " + value : m[0].str());
  }
  return all + rest;
}
// The look-ahead of a monitor that may have none.
std::string looks_ahead(const About& a, const std::string& value) {
  const Span m = a.monitor();
  const std::string changed = with(a.text, m, "ahead +", value);
  if (changed != a.text) return changed;
  const std::size_t recover = a.text.find("recover ", m.begin);
  return a.text.substr(0, recover) + "ahead " + value + "; " + a.text.substr(recover);
}
Offer robot_offer(const std::string& what, const std::string& unit, double grid, bool least,
                  const std::string& pattern) {
  return {what + " of at " + (least ? "least " : "most ") + number + " " + unit, unit, grid,
          least ? Beyond::less : Beyond::more, [pattern](const About& a, const std::string& value) {
            return with(a.text, a.robot(), pattern, value);
          }};
}
// The whole zone, so much wider on every side.
std::string grown(const About& a, const std::string& value) {
  const std::string zone = first_group(a.finding.help, "grow\\((\\w+),");
  return std::regex_replace(a.text, std::regex("(zone +" + zone + " *= *)([^;]*);"),
                            "$1grow($2, " + value + ");");
}

// What is wide in it alone.
std::string opened(const About& a, const std::string& value) {
  const std::string zone = first_group(a.finding.help, "grow\\(shrink\\((\\w+),");
  return std::regex_replace(a.text, std::regex("(zone +" + zone + " *= *)([^;]*);"),
                            "$1grow(shrink($2, " + value + "), " + value + ");");
}

// The recovery in the zone that is offered, with another number in that.
std::string moved_within(const About& a, const std::string& value) {
  const std::string zone = first_group(a.finding.help, "within a zone that is `([^`]*)` works");
  const Span s = a.recovery();
  const std::regex number_of("(, )[0-9.]+ m(?=\\))"), within("within +\\w+");
  return a.text.substr(0, s.begin) +
         "zone instead = " + std::regex_replace(zone, number_of, "$01" + value) + ";\n" +
         std::regex_replace(a.text.substr(s.begin, s.end - s.begin), within, "within instead") +
         a.text.substr(s.end);
}

std::vector<Offer> offers() {
  const auto part = [](Span (About::*which)() const, const std::string& pattern) {
    return [which, pattern](const About& a, const std::string& value) {
      return with(a.text, (a.*which)(), pattern, value);
    };
  };
  const auto of_robot = robot_offer;
  return {
      {"`ahead` of at most " + number + " ms", "ms", 1, Beyond::more, in_every_monitor},
      // a distance that grows with the speed, at the declared one: any larger one works as well
      {"`clearance\\(r, room\\) >= " + number +
           " m` works, which is what it comes to at [0-9.]+ m/s",
       "m", 1000, Beyond::nothing,
       [](const About& a, const std::string& value) {
         const std::regex grows("(clearance\\(d, room\\) >= )[0-9.]+ m \\+ [0-9.]+ s \\* d.speed");
         return std::regex_replace(a.text, grows, "$01" + value);
       },
       5006},
      {"`ahead " + number + " ms` works(?=, or a latency)", "ms", 1, Beyond::less, looks_ahead},
      {"^`" + number + " ms` works, or `unsound", "ms", 1, Beyond::less,
       part(&About::monitor, "ahead +"), 5001},
      {"or a latency of at most " + number + " ms", "ms", 1, Beyond::more,
       part(&About::robot, "latency +")},
      of_robot("`latency`", "ms", 1, false, "latency +"),
      of_robot("`max_age` of the position", "ms", 1, false, "position[^;]*max_age +"),
      of_robot("`max_age` of the velocity", "ms", 1, false, "velocity[^;]*max_age +"),
      {"`period` of at most " + number + " ms", "ms", 1, Beyond::more,
       part(&About::decision, "period +")},
      {"^less than " + number + " m/s\\^2 works", "m/s\\^2", 1000, Beyond::itself,
       part(&About::robot, "\\bdisturbance *<= *")},
      {"^at most " + number + " m/s\\^2(?=, or a| works)", "m/s\\^2", 1000, Beyond::more,
       part(&About::itself, ""), 5005},
      {"at least " + number + " m/s\\^2 works$", "m/s\\^2", 1000, Beyond::less,
       part(&About::robot, "\\bbrake *>= *"), 5005},
      {"`jitter` of at most " + number + " ms", "ms", 1, Beyond::more,
       part(&About::decision, "jitter +")},
      {"^less than " + number + " ms works, or a longer period", "ms", 1, Beyond::itself,
       part(&About::decision, "jitter +")},
      of_robot("`error` of the position", "m", 1000, false, "position[^;]*error +"),
      of_robot("`error` of the velocity", "m/s", 1000, false, "velocity[^;]*error +"),
      of_robot("`error` of the output", "m/s\\^2", 1000, false, "output[^;]*error +"),
      of_robot("`brake`", "m/s\\^2", 1000, true, "\\bbrake *>= *"),
      of_robot("`brake`", "m/s\\^2", 1000, false, "\\bbrake *>= *"),
      of_robot("`accel`", "m/s\\^2", 1000, false, "\\baccel *<= *"),
      of_robot("`speed` of the robot", "m/s", 1000, false, "\\bspeed *<= *"),
      of_robot("`turn`", "rad/s", 1000, false, "\\bturn *<= *"),
      of_robot("`disturbance`", "m/s\\^2", 1000, false, "\\bdisturbance *<= *"),
      of_robot("`radius`", "m", 1000, false, "\\bradius +"),
      {"`tracking <= " + number + " m` works", "m", 1000, Beyond::more,
       part(&About::robot, "tracking *<= *")},
      {"`drive` of at most " + number + " %/m works", "%/m", 100, Beyond::more,
       part(&About::robot, "drive *<= *")},
      {"`idle` of at most " + number + " %/s works", "%/s", 10'000, Beyond::more,
       part(&About::robot, "idle *<= *")},
      {"`held <= " + number + " s` works", "s", 10, Beyond::less,
       part(&About::robot, "held *<= *")},
      {"`detour <= " + number + " m` works", "m", 100, Beyond::less,
       part(&About::robot, "detour *<= *")},
      {"a clearance of at most " + number + " m works", "m", 1000, Beyond::more,
       part(&About::itself, ">= *")},
      {"^a clearance of " + number + " m works", "m", 1000, Beyond::more,
       part(&About::itself, ">= *")},
      {"^a limit of " + number + " m/s works", "m/s", 1000, Beyond::less,
       part(&About::itself, "<= *")},
      {"limits of at least " + number + " m/s work", "m/s", 1000, Beyond::less,
       part(&About::monitor, "\\.speed *<= *")},
      {"a distance of at most " + number + " m can be had", "m", 1000, Beyond::more,
       part(&About::itself, ">= *")},
      {"^`" + number + " %` works", "%", 10000, Beyond::more, part(&About::itself, ">= *")},
      {"a recovery of at most " + number + " m/s works", "m/s", 1000, Beyond::more,
       part(&About::recovery, "\\bspeed +")},
      {"a speed of at least " + number + " m/s works", "m/s", 1000, Beyond::less,
       part(&About::recovery, "\\bspeed +")},
      {"`land to " + number + " m` works", "m", 1000, Beyond::less,
       part(&About::recovery, "land to +")},
      {"`grow\\(\\w+, " + number + " m\\)` in place of `\\w+` wherever it is named works", "m",
       1000, Beyond::less, grown},
      {"`grow\\([^`(]+\\([^`]*, " + number + " m\\)` in place of `[a-z]+ \\([^`]*` works", "m",
       1000, Beyond::less,
       [](const About& a, const std::string& value) {
         const std::string was =
             first_group(a.finding.help, "in place of `([a-z]+ \\([^`]*)` works");
         return driver::test::edited(a.text, was, "grow(" + was + ", " + value + ")");
       }},
      {"`grow\\(\\w+, " + number + " m\\)` in place of `grow\\(\\w+, [0-9.]+ m\\)` works", "m",
       1000, Beyond::more,
       [](const About& a, const std::string& value) {
         const std::string was =
             first_group(a.finding.help, "in place of `(grow\\(\\w+, [0-9.]+ m\\))` works");
         return driver::test::edited(a.text, was, was.substr(0, was.find(',') + 2) + value + ")");
       }},
      {"`grow\\(shrink\\(\\w+, " + number + " m\\), [0-9.]+ m\\)`, which", "m", 1000, Beyond::less,
       opened},
      {"a zone with a ceiling of at most " + number + " m works", "m", 1000, Beyond::more,
       [](const About& a, const std::string& value) {
         const std::string zone = first_group(a.finding.message, "moves within `(\\w+)`");
         return with(a.text, statement_before(a.text, "zone +" + zone + "\\b", a.text.size()),
                     "\\) *from [0-9.]+ m to +", value);
       }},
      {"within a zone that is `[^`]*(?:grow|shrink)\\(\\w+, " + number + " m\\)` works", "m", 1000,
       Beyond::less, moved_within},
      {"`\\w+` at (\\([0-9.]+ m, [0-9.]+ m\\))", "", 0, Beyond::nothing,
       [](const About& a, const std::string& value) {
         const std::string site = first_group(a.finding.help, "`(\\w+)` at \\(");
         const Span s = statement_before(a.text, "site +" + site + "\\b", a.text.size());
         return a.text.substr(0, s.begin) +
                std::regex_replace(a.text.substr(s.begin, s.end - s.begin),
                                   std::regex("\\([^()]*\\);$"), value + ";") +
                a.text.substr(s.end);
       }},
      {"the place (\\([0-9.]+ m, [0-9.]+ m\\)) works", "", 0, Beyond::nothing,
       [](const About& a, const std::string& value) {
         const std::regex re("\\([^()]*\\);$");
         const Span s = statement_at(a.text, a.finding.begin);
         return a.text.substr(0, s.begin) +
                std::regex_replace(a.text.substr(s.begin, s.end - s.begin), re, value + ";") +
                a.text.substr(s.end);
       }},
      {"`(retreat within \\w+ speed [0-9.]+ m/s)` (?:works|leads back in)", "", 0, Beyond::nothing,
       [](const About& a, const std::string& value) {
         const Span s = a.recovery();
         return a.text.substr(0, s.begin) +
                std::regex_replace(a.text.substr(s.begin, s.end - s.begin),
                                   std::regex("(for +\\w+)[^;]*;"), "$1 = " + value + ";") +
                a.text.substr(s.end);
       }},
      {"`(extern keeps inside \\w+ speed <= [0-9.]+ m/s)` works", "", 0, Beyond::nothing,
       [](const About& a, const std::string& value) {
         const Span s = a.recovery();
         return a.text.substr(0, s.begin) +
                std::regex_replace(a.text.substr(s.begin, s.end - s.begin), std::regex("extern;"),
                                   value + ";") +
                a.text.substr(s.end);
       }},
  };
}

// Numbers of which this test cannot tell: an example of what the author has to know, or one that
// another test tries.
struct Elsewhere {
  const char *pattern, *where;
};
const std::vector<Elsewhere> tried_elsewhere = {
    {"add `brake >= 1 m/s\\^2;` with the robot's own value", "an example"},
    {"`output thrust : acceleration error 0.05 m/s\\^2;`", "an example"},
    {"`distance\\(r, room\\) >= 0 m` works, which says", "no number"},
    {"`ahead 200 ms, 2 waypoints`", "an example"},
    {"tracking <= 10 cm", "an example"},
    {"`retreat within Z speed 0.1 m/s`", "an example"},
    {"in `[^`]*` other errors are left", "Repairs.ANumberThatMendsHalfOfAMonitorIsNotOffered"},
    {"no place of a zone that is `[^`]*` has a clearance of [0-9.]+ m", "what is"},
    {"a wider zone and a latency of at most [0-9.]+ ms are needed", "not alone"},
    {"^no place of `\\w+` has a clearance of [0-9.]+ m:", "what is"},
    {"[0-9.]+ ms or [0-9.]+ ms works", "Repairs.BothNeighboursOf..."},
    {"it is about [0-9.]+ m wide there(?:, as cells of [0-9.]+ m tell)?", "what is"},
    {"; control returns [0-9.]+ m from the boundary", "what is"},
    {"zones that have a place in common with a clearance of [0-9.]+ m are needed",
     "what is needed"},
    {"a site with a clearance of [0-9.]+ m is needed", "what is needed"},
    {"zones (?:are needed )?that overlap by about [0-9.]+ m", "what is needed"},
    {"a zone that is `[^`]*` is needed, and not alone", "Offers.AZoneSuitsWhoSharesTheRecovery"},
    {"places at least [0-9.]+ m apart are needed", "Sites.PlacesAreAsFarApartAsTwoRobotsMayBe"},
    {"a window of more than [0-9.]+ s works", "Windows.OfAZoneToStayInAreLongEnough"},
    {"a zone in which a place has a clearance of [0-9.]+ m works",
     "Recoveries.AClaimIsLargeEnoughToBeSeenToHold"},
};

// ---- the test -----------------------------------------------------------------------------------

class Minimal : public ::testing::TestWithParam<std::string> {};

struct Tried {
  std::set<int> errors;
  std::vector<Finding> all;
};
Tried tried(const std::string& text, bool offers) {
  const auto c = compiled(text, offers);
  Tried t;
  t.all = findings(*c, text);
  for (const auto& d : c->diagnostics.all()) {
    if (diag::info(d.code).severity == diag::Severity::error)
      t.errors.insert(static_cast<int>(d.code));
  }
  return t;
}
bool found(const Tried& t, const Finding& f, bool any_message) {
  return std::any_of(t.all.begin(), t.all.end(), [&](const Finding& other) {
    return other.code == f.code && other.line == f.line &&
           (any_message || other.message == f.message);
  });
}
// Of several errors with one cause an offer mends all, if any number does.
bool finds_more(const Tried& t, const Tried& than) {
  return std::any_of(t.all.begin(), t.all.end(), [&](const Finding& f) {
    return diag::info(diag::Code(f.code)).severity == diag::Severity::error &&
           !found(than, f, true);
  });
}
// On the grid, five per cent beyond the number or a step; or the 5 mm that what is grown has more
// than the check asks for, since the recheck of a proof may miss them beside round corners.
std::string beyond(const std::string& value, const Offer& offer) {
  const double steps = std::stod(value) * offer.grid;
  const double least = std::string(offer.pattern).find("grow") != std::string::npos ? 6 : 1;
  const double far = offer.beyond == Beyond::more
                         ? std::max(std::ceil(steps * 1.05 - 1e-6), steps + least)
                         : std::min(std::floor(steps * 0.95 + 1e-6), steps - least);
  std::ostringstream text;
  text << std::fixed << std::max(far, 0.0) / offer.grid;
  return text.str();
}

TEST_P(Minimal, NumbersWorkAndFivePerCentBeyondThemDoNot) {
  std::set<std::string> seen;
  const std::string text = whole(fs::path(RTAC_SOURCE_DIR) / GetParam(), seen);
  const Tried before = tried(text, true);
  for (const Finding& f : before.all) {
    if (f.code < 5000 || f.code >= 7000) continue;
    const About about{text, f};
    std::string left = f.help;
    for (const Offer& offer : offers()) {
      if (offer.code != 0 && offer.code != f.code) continue;
      std::smatch m;
      if (!std::regex_search(f.help, m, std::regex(offer.pattern))) continue;
      const std::string unit = std::regex_replace(offer.unit, std::regex("\\\\"), "");
      const std::string value = m[1], shown = m[0];
      left = std::regex_replace(left, std::regex(offer.pattern), "");
      SCOPED_TRACE(std::to_string(f.code) + " line " + std::to_string(f.line + 1) + ": " +
                   f.message + "\n" + f.help + "\n" + shown);
      const std::string works = offer.beyond == Beyond::itself ? beyond(value, offer) : value;
      const std::string changed = offer.apply(about, works + (unit.empty() ? "" : " " + unit));
      EXPECT_NE(changed, text) << "nothing is changed";
      const Tried with_it = tried(changed, false);
      EXPECT_FALSE(found(with_it, f, false)) << "does not work";
      for (const int code : with_it.errors) {
        EXPECT_TRUE(before.errors.count(code)) << "it brings " << code;
      }
      if (offer.beyond == Beyond::nothing) continue;
      const std::string far = offer.beyond == Beyond::itself ? value : beyond(value, offer);
      const Tried too_far = tried(offer.apply(about, far + " " + unit), false);
      EXPECT_TRUE(found(too_far, f, true) || finds_more(too_far, with_it))
          << far << " works as well";
    }
    for (const Elsewhere& each : tried_elsewhere) {
      left = std::regex_replace(left, std::regex(each.pattern), "");
    }
    if (std::regex_search(left, std::regex("[0-9] ?(?:m|s|%)"))) {
      ADD_FAILURE() << f.code << ": nobody tries the number of `" << left << "`";
    }
  }
}

std::vector<std::string> specs() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(fs::path(RTAC_SOURCE_DIR) / "tests/golden")) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("bad_5") && !name.starts_with("bad_6")) continue;
    all.push_back("tests/golden/" + name + "/spec.rta");
  }
  for (const auto& entry :
       fs::directory_iterator(fs::path(RTAC_SOURCE_DIR) / "tests/compiler/verify/refuted")) {
    if (entry.path().stem() == "battery" || entry.path().stem() == "parts") continue;
    all.push_back("tests/compiler/verify/refuted/" + entry.path().filename().string());
  }
  for (const auto& entry :
       fs::directory_iterator(fs::path(RTAC_SOURCE_DIR) / "tests/compiler/analysis/repairs")) {
    all.push_back("tests/compiler/analysis/repairs/" + entry.path().filename().string());
  }
  std::sort(all.begin(), all.end());
  return all;
}
INSTANTIATE_TEST_SUITE_P(Specs, Minimal, ::testing::ValuesIn(specs()), [](const auto& of) {
  const std::string name = std::regex_replace(of.param, std::regex("(/spec)?\\.rta$"), "");
  return std::regex_replace(name.substr(name.rfind('/') + 1), std::regex("\\W"), "_");
});

TEST(SlowTests, OfTheAnalysisAreThere) {
  EXPECT_EQ(rtac::test::slow_tests_gone("compiler_analysis"), std::set<std::string>{});
}

}  // namespace
}  // namespace rtac::analysis::test
