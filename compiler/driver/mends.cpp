#include "compiler/driver/mends.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/driver/model_checker.h"
#include "compiler/driver/rewriting.h"
#include "compiler/driver/show.h"
#include "compiler/geometry/looks.h"
#include "compiler/verify/obligations.h"

namespace rtac::driver {
namespace {

using verify::Mend;
using verify::Obligation;
using verify::Report;
using verify::Status;

// Each is as much work as the specification itself: so many of an obligation, and as many of two
// together, and none after what has taken more than some 20 s (geometry/looks.h), or so long of
// the model checker and all else.
constexpr std::size_t tries_most = 6;
constexpr std::int64_t looks_most = 800'000'000;
constexpr std::int64_t shown_us_most = 30'000'000;

bool is_open(const Obligation& o) {
  return o.status != Status::proved && o.status != Status::acknowledged;
}

// Of what is not proved or accepted, or of that what is refuted: the decision, the kind, the
// monitor and the recovery.
using Key = std::tuple<std::string, verify::Kind, std::string, std::string>;
Key key_of(const std::string& decision, const Obligation& o) {
  return {decision, o.kind, o.monitor, o.recovery};
}
std::set<Key> open_of(const Report& report, bool refuted) {
  std::set<Key> open;
  for (const verify::Decision& d : report.decisions) {
    for (const Obligation& o : d.obligations) {
      if (!is_open(o) || (refuted && o.status != Status::refuted)) continue;
      open.insert(key_of(d.name, o));
    }
  }
  return open;
}

std::int64_t micros_of(const Report& report) {
  std::int64_t all = 0;
  for (const verify::Decision& d : report.decisions) {
    for (const Obligation& o : d.obligations) all += o.micros;
  }
  return all;
}

// The first of each kind before the second one of any.
std::vector<Mend> by_turns(const std::vector<Mend>& mends) {
  std::map<std::size_t, std::size_t> of_kind;
  std::vector<std::pair<std::size_t, const Mend*>> turns;
  for (const Mend& mend : mends) turns.emplace_back(of_kind[mend.index()]++, &mend);
  std::ranges::stable_sort(turns, {}, [](const auto& turn) { return turn.first; });
  std::vector<Mend> all;
  for (const auto& [turn, mend] : turns) all.push_back(*mend);
  return all;
}

// What one obligation takes to be shown.
class Mending {
 public:
  Mending(Compilation& c, const PlayAnew& play, const Report& report, const std::string& decision,
          const Obligation& o, std::int64_t& left_us)
      : c_(c),
        play_(play),
        left_us_(left_us),
        key_(key_of(decision, o)),
        refuted_(open_of(report, true)),
        open_(open_of(report, false)) {}

  // In words; "": nothing that was tried mends it. Numbers that are looked for; or one mend, or the
  // second one that is offered of what the first one leaves of it.
  std::string run(const std::vector<Mend>& offered) {
    if (std::string numbers = numbers_that_work(offered); !numbers.empty()) return numbers;
    const std::vector<Mend> mends = by_turns(offered);
    std::vector<std::pair<const Mend*, std::vector<Mend>>> left;
    for (std::size_t k = 0; k < std::min(mends.size(), tries_most); ++k) {
      if (is_sought(mends[k])) continue;
      const std::string text = text_of(*c_.spec, mends[k]);
      const auto anew = text.empty() ? std::nullopt : with(mends[k]);
      if (!anew) continue;
      if (mends_it(*anew)) return text + " works" + as_played();
      // what works beside a wider zone would be said of that one
      if (std::holds_alternative<verify::WiderZone>(mends[k])) continue;
      left.emplace_back(&mends[k], by_turns(leaves(*anew)));
    }
    std::size_t tries = 0;
    for (const auto& [first, more] : left) {
      const std::string text = text_of(*c_.spec, *first);
      const Rewriting written(*c_.spec, *first);
      for (std::size_t k = 0; k < more.size() && tries < tries_most; ++k) {
        // of a number that is looked for no more than a bound is known
        if (is_sought(more[k])) continue;
        const std::string besides = text_of(*c_.spec, more[k]);
        if (besides.empty()) continue;
        ++tries;
        const auto anew = with(more[k]);
        if (anew && mends_it(*anew)) return text + " and " + besides + " work, together";
      }
    }
    return "";
  }

 private:
  static bool is_sought(const Mend& mend) {
    return std::holds_alternative<verify::LessApart>(mend) ||
           std::holds_alternative<verify::RoomToPass>(mend);
  }
  std::string numbers_that_work(const std::vector<Mend>& mends) {
    std::string all;
    for (const Mend& mend : mends) {
      std::optional<Mend> found;
      is_cut_ = false;
      if (const auto* less = std::get_if<verify::LessApart>(&mend)) {
        found = most_that_works(*less);
      } else if (const auto* more = std::get_if<verify::RoomToPass>(&mend)) {
        found = least_that_works(*more);
      }
      if (!found) continue;
      all += (all.empty() ? "" : ", or ") + text_of(*c_.spec, *found) + " works";
      if (is_cut_) all += " (the time was up before nearer numbers were tried)";
    }
    return all;
  }
  // The largest distance with which it is shown, to a fiftieth of it; none: no smaller one helps.
  std::optional<Mend> most_that_works(const verify::LessApart& asked) {
    constexpr std::int64_t share = 50, hardly_any = 20;
    std::int64_t low_mm = 0, high_mm = asked.most_mm;
    while (high_mm - low_mm > (low_mm > 0 ? low_mm / share : asked.most_mm / hardly_any) + 1) {
      const std::int64_t middle_mm = low_mm + (high_mm - low_mm) / 2;
      const auto anew = with(verify::LessApart{asked.monitor, middle_mm});
      (anew && mends_it(*anew) ? low_mm : high_mm) = middle_mm;
    }
    if (low_mm == 0) return std::nullopt;
    return verify::LessApart{asked.monitor, low_mm};
  }
  // The least room with which it is shown, to less than a twentieth of it; none: no more is tried.
  // From little on, as a large zone takes long.
  std::optional<Mend> least_that_works(const verify::RoomToPass& most) {
    constexpr std::int64_t share = 25, first_part = 16;
    const auto works = [&](std::int64_t by_mm) {
      const auto anew = with(verify::RoomToPass{most.zone, by_mm});
      return anew && mends_it(*anew);
    };
    std::int64_t low_mm = 0, high_mm = std::max<std::int64_t>(most.by_mm / first_part, 1);
    while (!works(high_mm)) {
      low_mm = high_mm, high_mm *= 2;
      if (high_mm > most.by_mm || is_spent()) return std::nullopt;
    }
    while (high_mm - low_mm > high_mm / share + 1) {
      const std::int64_t middle_mm = low_mm + (high_mm - low_mm) / 2;
      (works(middle_mm) ? high_mm : low_mm) = middle_mm;
    }
    return verify::RoomToPass{most.zone, high_mm};
  }
  [[nodiscard]] bool is_spent() const {
    return left_us_ <= 0 || geometry::looks() - c_.looks_before > looks_most;
  }
  std::optional<Report> with(const Mend& mend) {
    is_cut_ = is_spent();
    if (is_cut_) return std::nullopt;
    const Rewriting written(*c_.spec, mend);
    auto built = written ? build_anew(*c_.spec, c_.sources) : std::nullopt;
    if (!built) return std::nullopt;
    Report anew = verify::verify(*c_.spec, &built->module, built->tables, built->diagnostics.all(),
                                 check_model);
    left_us_ -= micros_of(anew);
    leave_open(anew);  // no run is looked for
    by_runs_ = false;
    if (mends_it(anew) && !keeps_as_declared(anew, *built)) return std::nullopt;
    return anew;
  }
  // What is declared, of this and of all that was not open: no run refutes it.
  bool keeps_as_declared(const Report& anew, BuiltAnew& built) {
    Report declared{anew.spec, {}};
    for (const verify::Decision& d : anew.decisions) {
      verify::Decision of{d.name, d.kind, {}, {}};
      for (const Obligation& o : d.obligations) {
        if (o.declared && !is_open(o)) of.obligations.push_back(o);
      }
      if (!of.obligations.empty()) declared.decisions.push_back(std::move(of));
    }
    if (declared.decisions.empty()) return true;
    play_(built, declared);
    for (const verify::Decision& d : declared.decisions) {
      for (const Obligation& o : d.obligations) {
        const bool is_own = key_of(d.name, o) == key_;
        by_runs_ = by_runs_ || (is_own && o.played);
        if (is_own && !o.played) return false;
      }
    }
    return std::ranges::includes(open_, open_of(declared, false));
  }
  [[nodiscard]] std::string as_played() const {
    return by_runs_ ? ": no run under attack has made `" + std::get<2>(key_) + "` fail" : "";
  }
  // It is shown, and nothing is open, or refuted, that was not.
  [[nodiscard]] bool mends_it(const Report& anew) const {
    const std::set<Key> open = open_of(anew, false);
    return !open.contains(key_) && leaves_no_more(anew);
  }
  [[nodiscard]] bool leaves_no_more(const Report& anew) const {
    return std::ranges::includes(open_, open_of(anew, false)) &&
           std::ranges::includes(refuted_, open_of(anew, true));
  }
  // What may mend what is left of it.
  [[nodiscard]] std::vector<Mend> leaves(const Report& anew) const {
    if (!leaves_no_more(anew)) return {};
    for (const verify::Decision& d : anew.decisions) {
      for (const Obligation& o : d.obligations) {
        if (key_of(d.name, o) == key_) return o.mends;
      }
    }
    return {};
  }

  Compilation& c_;
  const PlayAnew& play_;
  std::int64_t& left_us_;
  const Key key_;
  const std::set<Key> refuted_, open_;
  bool by_runs_ = false;  // what was built last was played as well
  bool is_cut_ = false;   // there was no time for what was to be built last
};

}  // namespace

void offer_mends(Compilation& c, const PlayAnew& play, Report& report) {
  std::int64_t left_us = shown_us_most;
  for (verify::Decision& d : report.decisions) {
    for (Obligation& o : d.obligations) {
      if (!is_open(o) || (o.mends.empty() && o.or_else.empty())) continue;
      std::string works = Mending(c, play, report, d.name, o, left_us).run(o.mends);
      if (works.empty()) works = o.or_else;
      if (works.empty()) continue;
      o.repair = (o.besides && !o.repair.empty() ? o.repair + ", or " : "") + works;
    }
  }
}

}  // namespace rtac::driver
