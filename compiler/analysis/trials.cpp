#include "compiler/analysis/trials.h"

#include <algorithm>
#include <ctime>
#include <vector>

namespace rtac::analysis {
namespace {

// Of one specification: a report is no search that lasts. In seconds of the processor, so that what
// is offered does not hang on what else the machine does.
constexpr int runs_most = 200, seconds_most = 30;
// From the guess to the last number, each so many times nearer to that.
constexpr std::int64_t times_farther = 4;
constexpr std::size_t probes_most = 6;

std::vector<std::int64_t> probes(std::int64_t guess, std::int64_t far) {
  std::vector<std::int64_t> all{guess};
  while (all.back() != far && all.size() < probes_most) {
    const std::int64_t last = all.back();
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
std::ptrdiff_t wrong(const Faults& found) {
  return std::ranges::count_if(found, [](const Fault& each) { return !is_remark(each.code); });
}
bool no_more(const Faults& found, const Faults& than) {
  return std::ranges::all_of(
      found, [&](const Fault& each) { return is_remark(each.code) || than.contains(each); });
}

}  // namespace

Fault fault_of(diag::Code code, const std::optional<SourceRange>& range) {
  return range ? Fault{code, range->file, range->begin} : Fault{code, {}, 0};
}

Faults faults_of(const diag::Engine& diagnostics) {
  Faults all;
  for (const diag::Diagnostic& d : diagnostics.all()) {
    if (diag::info(d.code).severity == diag::Severity::error ||
        d.code == diag::Code::monitor_vacuous || is_remark(d.code)) {
      all.insert(fault_of(d.code, d.range));
    }
  }
  return all;
}

const Faults& Trials::as_written() {
  if (!as_written_) as_written_ = run_(true);
  return *as_written_;
}

const Faults* Trials::with(const Dial& dial, std::int64_t steps) {
  const auto [at, is_new] = known_.try_emplace({dial.name, steps});
  if (is_new && runs_ < runs_most && ticks_ / CLOCKS_PER_SEC < seconds_most) {
    const std::clock_t start = std::clock();
    if (dial.write(steps)) {
      ++runs_;
      at->second = run_(!dial.of_zone);
    }
    dial.restore();
    ticks_ += std::clock() - start;
  }
  return at->second ? &*at->second : nullptr;
}

bool Trials::mends(const Faults* found, const Fault& fault,
                   const std::optional<SourceRange>& all_of) {
  const auto is_left = [&](const Fault& each) {
    return all_of && is_of_places(each.code) && each.file == all_of->file &&
           each.begin >= all_of->begin && each.begin < all_of->end;
  };
  return found != nullptr && !found->contains(fault) && std::ranges::none_of(*found, is_left) &&
         no_more(*found, as_written());
}

std::optional<std::int64_t> Trials::nearest(const Dial& dial, std::int64_t guess,
                                            const Fault& fault,
                                            const std::optional<SourceRange>& all_of) {
  std::optional<std::int64_t> good;
  const Faults* left = nullptr;
  std::int64_t bad = dial.written, before = dial.written;
  for (const std::int64_t at : probes(guess, dial.far)) {
    const Faults* const found = with(dial, at);
    if (mends(found, fault, all_of) && (!good || wrong(*found) < wrong(*left))) {
      good = at;
      left = found;
      bad = before;
    }
    if (good && wrong(*left) == 0) break;
    before = at;
  }
  if (!good) return std::nullopt;
  const auto works = [&](std::int64_t at) {
    const Faults* const found = with(dial, at);
    return found != nullptr && !found->contains(fault) && no_more(*found, *left);
  };
  const std::int64_t next = *good + (bad > *good ? 1 : -1);
  if (next == bad || !works(next)) return good;  // most guesses are right
  good = next;
  while (std::abs(bad - *good) > 1) {
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
