#include "compiler/syntax/habits.h"

#include <algorithm>
#include <iterator>

namespace rtac::syntax {
namespace {

struct Habit {
  std::string_view word, help;
};

constexpr std::string_view kOnce =
    "monitors look back: write `once[0 s, 2 s] x`, or `x within 2 s of y` for what must follow";
constexpr std::string_view kHistorically =
    "`always` stands once, in front of the whole property; inside of it, write "
    "`historically[0 s, 2 s] x`";
constexpr std::string_view kPreviously = "monitors look back by a tick: write `previously x`";
constexpr std::string_view kUntil =
    "monitors look back: write `x since y`, or `y within 2 s of x` for a deadline";
constexpr std::string_view kFollow =
    "write `x within 2 s of y` for what must follow, `x since y` for what lasts";
constexpr std::string_view kEqual = "values of an enumeration are compared by `==` and `!=`";
constexpr std::string_view kAlways =
    "write `always` in front of the property, `always not x` for "
    "what must never be";

// Inside of expressions.
constexpr Habit kOperators[] = {
    {"eventually", kOnce},
    {"finally", kOnce},
    {"sometime", kOnce},
    {"F", kOnce},
    {"O", kOnce},
    {"globally", kHistorically},
    {"henceforth", kHistorically},
    {"always", kHistorically},
    {"G", kHistorically},
    {"H", kHistorically},
    {"next", kPreviously},
    {"prev", kPreviously},
    {"previous", kPreviously},
    {"pre", kPreviously},
    {"yesterday", kPreviously},
    {"X", kPreviously},
    {"Y", kPreviously},
    {"until", kUntil},
    {"release", kUntil},
    {"U", kUntil},
    {"W", kUntil},
    {"S", "write `x since y`"},
    {"after", kFollow},
    {"before", kFollow},
    {"is", kEqual},
    {"equals", kEqual},
    {"contains", "the place comes first: write `p inside room`"},
    {"outside", "write `not p inside room`"},
    {"between", "write both ends: `x >= 0 m and x <= 3 m`"},
};

constexpr std::string_view kChange =
    "the change of a quantity is `rate[0 s, 1 s](x)`, per second over that time; "
    "`previously` goes in front of a condition";
constexpr std::string_view kMean = "the mean over a window is `mean[0 s, 1 s](x)`";

// Called like functions.
constexpr Habit kFunctions[] = {
    {"prev", kChange},
    {"previous", kChange},
    {"last", kChange},
    {"pre", kChange},
    {"delay", kChange},
    {"derivative", kChange},
    {"diff", kChange},
    {"der", kChange},
    {"ddt", kChange},
    {"delta", kChange},
    {"avg", kMean},
    {"average", kMean},
    {"mean_of", kMean},
    {"total", "the sum over a window is `sum[0 s, 1 s](x)`"},
    {"integral",
     "the sum over a window is `sum[0 s, 1 s](x)`: times the period it is the integral"},
    {"length", "the length of a vector is `norm(v)`"},
    {"magnitude", "the length of a vector is `norm(v)`"},
    {"mag", "the length of a vector is `norm(v)`"},
    {"fabs", "the absolute value is `abs(x)`"},
    {"square", "multiply by `*`: `x * x`"},
    {"sq", "multiply by `*`: `x * x`"},
    {"stddev", "compute it outside, and pass it as `input ... error e`"},
    {"fresh", "the time since the newest sample is `age(x)`: `age(x) <= 200 ms`"},
    {"stale", "the time since the newest sample is `age(x)`: `age(x) > 200 ms`"},
    {"time", "the time since the newest sample of an input is `age(x)`"},
    {"now", "the time since the newest sample of an input is `age(x)`"},
    {"speed", "the speed of a robot is `r.speed`"},
    {"velocity", "the speed of a robot is `r.speed`"},
    {"altitude", "the height of a robot in space is `r.position.z`"},
    {"height", "the height of a robot in space is `r.position.z`"},
    {"battery", "the charge of a robot is `r.battery`"},
    {"energy", "the charge of a robot is `r.battery`, that of a way `energy_to(dock(r))`"},
};

constexpr std::string_view kParam =
    "write a constant where it is used, or as a `param`: "
    "`param gap : length in 0.1 m .. 0.5 m = 0.2 m;`";
constexpr std::string_view kFun = "write `fun slow(v : real [m/s]) : bool = v <= 1 m/s;`";
constexpr std::string_view kInput = "what is measured is an input: `input open : bool;`";
constexpr std::string_view kPeriod = "monitors run once a period: `period 100 ms;` for 10 Hz";
constexpr std::string_view kImport = "a file is imported by `import \"robots.rta\";`";
constexpr std::string_view kMonitor =
    "properties stand in monitors: `monitor calm { \"R1\" always speed <= 1 m/s; }`";

// At the start of items.
constexpr Habit kItems[] = {
    {"const", kParam},
    {"constant", kParam},
    {"define", kParam},
    {"parameter", kParam},
    {"def", kFun},
    {"func", kFun},
    {"function", kFun},
    {"fn", kFun},
    {"var", kInput},
    {"variable", kInput},
    {"signal", kInput},
    {"sensor", kInput},
    {"topic", kInput},
    {"stream", kInput},
    {"in", kInput},
    {"property", kMonitor},
    {"assert", kMonitor},
    {"rule", kMonitor},
    {"requirement", kMonitor},
    {"always", kMonitor},
    {"invariant", kMonitor},
    {"bool", kInput},
    {"boolean", kInput},
    {"int", kInput},
    {"real", kInput},
    {"float", kInput},
    {"double", kInput},
    {"rate", kPeriod},
    {"frequency", kPeriod},
    {"freq", kPeriod},
    {"tick", kPeriod},
    {"dt", kPeriod},
    {"include", kImport},
    {"require", kImport},
    {"use", kImport},
    {"using", kImport},
    {"load", kImport},
    {"type", "values by name are an `enum Gear { park, drive }`"},
    {"output", "what monitors find is their output: nothing declares it"},
    {"out", "what monitors find is their output: nothing declares it"},
};

// At the start of clauses of a monitor.
constexpr Habit kClauses[] = {
    {"never", kAlways},  {"globally", kAlways}, {"G", kAlways},
    {"assert", kAlways}, {"require", kAlways},  {"must", kAlways},
};

template <class Table>
std::optional<std::string_view> find_help(const Table& table, std::string_view word) {
  const auto* found = std::find_if(std::begin(table), std::end(table),
                                   [&](const Habit& each) { return each.word == word; });
  return found == std::end(table) ? std::nullopt : std::optional(found->help);
}

}  // namespace

std::optional<std::string_view> operator_habit(std::string_view word) {
  return find_help(kOperators, word);
}
std::optional<std::string_view> function_habit(std::string_view word) {
  const auto help = find_help(kFunctions, word);
  return help ? help : find_help(kOperators, word);
}
std::optional<std::string_view> item_habit(std::string_view word) {
  return find_help(kItems, word);
}
std::optional<std::string_view> clause_habit(std::string_view word) {
  return find_help(kClauses, word);
}

}  // namespace rtac::syntax
