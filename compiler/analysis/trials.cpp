#include "compiler/analysis/trials.h"

#include <algorithm>
#include <utility>

namespace rtac::analysis {
namespace {

// Of one specification: a report is no search that lasts. Efforts are of 30 to 90 s, and of a
// third.
constexpr int runs_most = 200;
constexpr std::int64_t effort_most = 4'500'000, effort_of_remark_most = 1'500'000;
// Besides, runs that ask what is shown, of 10 to 30 s; after that, nothing more is offered.
constexpr int shown_most = 40;
constexpr std::int64_t effort_of_shown_most = 1'500'000;
// Where a run takes long, a number is looked for to within this share of it.
constexpr std::int64_t near_enough = 200;
// From the guess to the last number, each so many times nearer to that.
constexpr std::int64_t times_farther = 4;
constexpr std::size_t probes_most = 6;
// Where the guess is what reports ask for, a little more is mostly what is shown: these shares.
constexpr std::int64_t little_more[] = {100, 25};

// So much less, or more, than is written is no repair.
bool is_another_robot(std::int64_t written, std::int64_t steps) {
  constexpr std::int64_t times = 10;
  return written > 0 && (steps * times < written || steps > written * times);
}

std::vector<std::int64_t> probes(std::int64_t guess, std::int64_t far, bool shown) {
  std::vector<std::int64_t> all{guess};
  for (const std::int64_t share : little_more) {
    const std::int64_t by = std::max<std::int64_t>(1, guess / share);
    if (shown && std::abs(far - guess) > by) all.push_back(far < guess ? guess - by : guess + by);
  }
  const std::size_t most = all.size() - 1 + probes_most;
  for (std::int64_t last = guess; last != far && all.size() < most; last = all.back()) {
    all.push_back(far < last ? std::max(far, last / times_farther)
                             : std::min(far, last * times_farther));
  }
  return all;
}

// A monitor and its recovery do not go together: where control returns, where it leads.
bool is_of_places(diag::Code code) {
  return code == diag::Code::return_set_empty || code == diag::Code::recovery_elsewhere;
}

// What may be meant so: a number may mend it, and is none the worse for it.
bool is_remark(diag::Code code) {
  return code == diag::Code::corridor_too_narrow || code == diag::Code::no_way_back;
}
bool is_wrong(const Fault& each) {
  return each.open.empty() && !is_remark(each.code);
}
std::ptrdiff_t wrong(const Faults& found) {
  return std::ranges::count_if(found.all, is_wrong);
}
bool no_more_wrong(const Faults& found, const Faults& than) {
  return std::ranges::all_of(
      found.all, [&](const Fault& each) { return !is_wrong(each) || than.all.contains(each); });
}
bool no_more_open(const Faults& found, const Faults& than) {
  if (!than.complete) return true;  // nobody knows what was open
  return found.complete && std::ranges::all_of(found.all, [&](const Fault& each) {
           return each.open.empty() || than.all.contains(each);
         });
}

}  // namespace

Fault fault_of(diag::Code code, const std::optional<SourceRange>& range) {
  return range ? Fault{code, range->file, range->begin} : Fault{code, {}, 0};
}

Faults faults_of(const diag::Engine& diagnostics) {
  Faults found;
  for (const diag::Diagnostic& d : diagnostics.all()) {
    if (diag::info(d.code).severity == diag::Severity::error ||
        d.code == diag::Code::monitor_vacuous || is_remark(d.code)) {
      found.all.insert(fault_of(d.code, d.range));
    }
  }
  return found;
}

std::string as_tried(const Trials* trials, std::string none) {
  if (trials == nullptr || !trials->ran_out()) return none;
  return "there was no time to try more numbers" +
         std::string(trials->by_reports_alone()
                         ? ""
                         : "; `rtac check` offers those that its reports ask for");
}

std::optional<sema::ZoneId> Trials::zone_of(ir::ZoneIndex table) const {
  const auto found = std::ranges::find(zones_, std::optional(table));
  if (found == zones_.end()) return std::nullopt;
  return sema::ZoneId(found - zones_.begin());
}

const Faults& Trials::as_written(bool shown) {
  if (!as_written_ || (shown && !asked_)) {
    asked_ = shown;
    as_written_ = run_({true, true, [&](const Faults&) { return shown; }});
  }
  return *as_written_;
}

const Faults* Trials::with(const Dial& dial, std::int64_t steps, const Goal& goal,
                           const Worth& worth, std::int64_t most_effort) {
  const auto [at, is_new] = known_.try_emplace({dial.name, steps});
  const bool remarks = goal.shown || is_remark(goal.fault.code);
  const bool knows_less = !is_new && at->second && (remarks && !at->second->remarks);
  const bool asks_more =
      knows_less || (!is_new && at->second && !at->second->complete && worth(*at->second));
  const bool may_run = runs_ < runs_most && effort_ < most_effort;
  if ((is_new || asks_more) && !may_run) {
    ran_out_ = true;
    if (knows_less) return nullptr;
  } else if (is_new || asks_more) {
    if (dial.write(steps)) {
      ++runs_;
      at->second = run_({!dial.of_zone, remarks, worth});
    }
    dial.restore();
    if (at->second) {
      shown_ += at->second->effort_of_shown > 0 ? 1 : 0;
      effort_ += at->second->effort;
      effort_of_shown_ += at->second->effort_of_shown;
    }
  }
  return at->second ? &*at->second : nullptr;
}

bool Trials::may_show() const {
  return shown_ < shown_most && effort_of_shown_ < effort_of_shown_most;
}

std::set<diag::Code> Trials::wrong_with(const Faults& found, const Goal& goal) {
  const Faults& written = as_written(goal.shown);
  const auto is_left = [&](const Fault& each) {
    const auto& all_of = goal.all_of;
    return all_of && is_of_places(each.code) && each.open.empty() && each.file == all_of->file &&
           each.begin >= all_of->begin && each.begin < all_of->end;
  };
  std::set<diag::Code> codes;
  for (const Fault& each : found.all) {
    const bool comes = is_wrong(each) && !written.all.contains(each);
    if (each == goal.fault || is_left(each) || comes) codes.insert(each.code);
  }
  return codes;
}

bool Trials::mends(const Faults& found, const Goal& goal) {
  return wrong_with(found, goal).empty();
}

std::string Trials::left_last() const {
  std::string text;
  for (const diag::Code code : left_) {
    text += (text.empty() ? "" : "; ") + std::to_string(static_cast<int>(code)) + ": " +
            diag::info(code).title;
  }
  return text;
}

// What is not shown of another monitor has another cause.
std::vector<std::string> Trials::open_at(const Faults& found, const Fault& fault) const {
  const auto is_at = [](const sema::Monitor& m, const Fault& each) {
    return each.file == m.range.file && each.begin >= m.range.begin && each.begin < m.range.end;
  };
  const auto of =
      std::ranges::find_if(spec_.monitors, [&](const sema::Monitor& m) { return is_at(m, fault); });
  std::vector<std::string> open;
  for (const Fault& each : found.all) {
    const auto elsewhere = [&](const sema::Monitor& m) { return &m != &*of && is_at(m, each); };
    if (each.open.empty()) continue;
    if (of != spec_.monitors.end() && std::ranges::any_of(spec_.monitors, elsewhere)) continue;
    open.push_back(each.open);
  }
  return open;
}

const Faults* Trials::known_of(const std::string& dial, std::int64_t steps) const {
  const auto at = known_.find({dial, steps});
  return at != known_.end() && at->second ? &*at->second : nullptr;
}

std::ptrdiff_t Trials::left_with(const std::string& dial, std::int64_t steps) const {
  const Faults* const found = known_of(dial, steps);
  if (found == nullptr) return 0;
  return std::ranges::count_if(found->all, [](const Fault& f) { return !f.open.empty(); });
}

std::string Trials::leaves(const std::string& dial, std::int64_t steps, const Fault& fault) const {
  const Faults* const found = known_of(dial, steps);
  if (found == nullptr) return "";
  const std::string rough =
      rough_.contains({dial, steps}) ? " (there was no time to try nearer ones)" : "";
  std::set<std::string> open;  // of several monitors the same once
  for (const std::string& each : open_at(*found, fault)) {
    open.insert(each.substr(0, each.find_last_not_of(' ') + 1));
  }
  std::string names;
  for (const std::string& each : open) names += (names.empty() ? "" : ", ") + each;
  return (names.empty() ? "" : " (which leaves " + names + " open)") + rough;
}

bool Trials::shows_no_less(const Faults& found) {
  return no_more_open(found, as_written(true));
}

std::optional<std::int64_t> Trials::nearest(const Dial& dial, std::int64_t guess,
                                            const Fault& fault,
                                            const std::optional<SourceRange>& all_of) {
  // to ask what is shown takes longer: first by the reports alone, and that is mostly it
  const Goal by_reports{fault, all_of, false}, shown{fault, all_of, true};
  const auto first = least_wrong(dial, guess, by_reports);
  const Faults* const tried = first ? nullptr : known_of(dial.name, guess);
  left_ = tried != nullptr ? wrong_with(*tried, by_reports) : std::set<diag::Code>{};
  if (first && is_remark(fault.code) && is_another_robot(dial.written, *first)) return std::nullopt;
  if (!first || reports_alone_) return first;
  // what nobody has the time to show is not said to work
  if (!may_show()) ran_out_ = true;
  const auto best = may_show() ? least_wrong(dial, *first, shown) : std::nullopt;
  if (!best) return cannot_be_shown(dial, *first) && !is_remark(fault.code) ? first : std::nullopt;
  // a report that is gone may have been about one place of several
  const auto found = known_.find({dial.name, *best});
  const bool is_shown = found->second && open_at(*found->second, fault).empty();
  return is_remark(fault.code) && !is_shown ? std::nullopt : best;
}

// Other errors, of what is written, too, leave nothing of which anything could be shown: what the
// reports say is all that is known.
bool Trials::cannot_be_shown(const Dial& dial, std::int64_t steps) {
  const Faults* const found = known_of(dial.name, steps);
  return found != nullptr && !found->derived && !as_written(true).derived;
}

std::optional<std::int64_t> Trials::least_wrong(const Dial& dial, std::int64_t guess,
                                                const Goal& goal) {
  const bool before = std::exchange(ran_out_, false);
  const auto found = looked_for(dial, guess, goal);
  if (found && ran_out_) rough_.insert({dial.name, *found});
  ran_out_ = ran_out_ || before;
  return found;
}

std::optional<std::int64_t> Trials::looked_for(const Dial& dial, std::int64_t guess,
                                               const Goal& goal) {
  as_written(goal.shown);  // before another number is written
  const auto no_less = [&](const Faults& found, const Faults& than) {
    return !goal.shown || (found.complete && no_more_open(found, than));
  };
  const auto left_by = [&](const Faults& found) {
    return wrong(found) + (goal.shown ? std::ssize(open_at(found, goal.fault)) : 0);
  };
  const Worth mends_it = [&](const Faults& found) {
    return goal.shown && mends(found, goal) && may_show();
  };
  // what the reports have taken is not missing where it is asked what is shown
  const std::int64_t most_effort =
      (is_remark(goal.fault.code) ? effort_of_remark_most : effort_most) +
      (goal.shown ? effort_of_shown_most : 0);
  std::optional<std::int64_t> good;
  const Faults* left = nullptr;
  std::int64_t bad = dial.written, before = dial.written;
  for (const std::int64_t at : probes(guess, dial.far, goal.shown)) {
    const Faults* const found = with(dial, at, goal, mends_it, most_effort);
    if (found != nullptr && mends(*found, goal) && no_less(*found, as_written(goal.shown)) &&
        (!good || left_by(*found) < left_by(*left))) {
      good = at;
      left = found;
      bad = before;
    }
    if (good && left_by(*left) == 0) break;
    before = at;
  }
  if (!good) return std::nullopt;
  const auto works = [&](std::int64_t at) {
    const Faults* const found = with(dial, at, goal, mends_it, most_effort);
    return found != nullptr && !found->all.contains(goal.fault) && no_more_wrong(*found, *left) &&
           no_less(*found, *left);
  };
  // so do those of zones that have to grow by more than a hall is wide, in mm
  constexpr std::int64_t far_growth = 10'000;
  const bool takes_long = dial.coarse || goal.shown || is_remark(goal.fault.code) ||
                          (dial.of_zone && *good > far_growth);
  const auto enough = [&] {
    return takes_long ? std::max<std::int64_t>(1, *good / near_enough) : 1;
  };
  // most guesses are right, or nearly so; where one was none, the number is anywhere in between
  const bool near = *good == guess;
  for (std::int64_t by = bad > *good ? enough() : -enough();
       near && std::abs(bad - *good) > std::abs(by); by *= 2) {
    if (!works(*good + by)) {
      bad = *good + by;
      break;
    }
    *good += by;
  }
  while (std::abs(bad - *good) > enough()) {
    const std::int64_t middle = *good + (bad - *good) / 2;
    if (works(middle)) {
      good = middle;
    } else {
      bad = middle;
    }
  }
  return good;
}

}  // namespace rtac::analysis
