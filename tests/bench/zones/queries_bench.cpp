// What it takes to ask about a zone: whether a place is in it, how far from its boundary, and
// whether a leg keeps clear of it; of the generated kernel and of libraries that prepare a zone for
// many questions, over outlines of 10 to 100,000 vertices.
//
// How. Places lie anywhere about the zone, within some metres of its boundary, or on the way of one
// robot along it, 5 cm apart, as at 1 m/s every 50 ms. They are in the form that the asked one
// takes before the clock starts. A pass asks about all 4,000 of them or, of whoever takes longer
// than a pass may, about the next ones; passes are taken in turns. No place comes again before all
// others have, since what branches a hundred places take a processor learns by heart, which
// flatters whoever takes many. Two more rows of 100 and of 100,000 vertices say what the caches are
// worth: `cached` asks in batches of 50 places, each after the same questions without the clock, so
// that what it needs of the tables, some lines of a cache for each place, is in the first cache,
// where all 4,000 places of 100,000 vertices need more than a second one has; `cold` are single
// questions, each after memory as large as the last cache has been walked through, less what the
// clock takes.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/bench/benchmarks.h"
#include "tests/bench/watch/contest.h"
#include "tests/bench/zones/contender.h"
#include "tests/bench/zones/generated.h"

namespace rtac::bench {
namespace {

constexpr std::int32_t near_mm = 3'000, leg_mm = 5'000;
constexpr std::int32_t step_mm = 50;  // of a robot on its way
constexpr std::size_t batch_places = 50;
constexpr std::array places_of{"anywhere", "near", "along"};

struct Subject {
  const char* shape;
  std::size_t vertices;
  Outline outline;
  std::unique_ptr<Generated> generated;  // nullptr: it cannot be compiled
  [[nodiscard]] std::string title() const {
    return std::string(shape) + " of " + std::to_string(vertices) + " vertices";
  }
  [[nodiscard]] std::string key() const {
    return std::string(shape) + "_" + std::to_string(vertices);
  }
};

constexpr std::array<const char*, 3> question_titles{
    "Zones: is a place inside", "Zones: how far is a place from the boundary",
    "Zones: does a leg keep clear of the boundary"};
constexpr std::array<const char*, 3> question_keys{"inside", "clearance", "leg"};

std::vector<Contender> contenders(Question question, const Subject& subject,
                                  const std::vector<GridPlace>& places) {
  std::vector<Contender> all;
  if (subject.generated) all.push_back(subject.generated->contender(question, places));
  const auto take = [&](std::vector<Contender> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  };
  switch (question) {
    case Question::inside:
      take(cgal_inside(subject.outline, places));
      break;
    case Question::clearance:
      take(cgal_clearance(subject.outline, places));
      break;
    case Question::leg:
      take(cgal_legs(subject.outline, places));
      break;
  }
  take(geos_contenders(question, subject.outline, places));
  return all;
}

// The answers are the same, as far as they can be compared. Places on the boundary may count as
// either; distances of the kernel are lower bounds, close within the horizon.
bool agree(Question question, bool is_near, double ours, double theirs, std::size_t count) {
  const auto n = static_cast<double>(count);
  if (question == Question::inside) return std::abs(ours - theirs) <= 2 + n / 100;
  return ours <= theirs + 1e-6 * n && (!is_near || ours >= theirs - 3 * n);
}

class QueryBench {
 public:
  QueryBench(const Effort& effort, Report& report) : effort_(effort), report_(report) {}

  // Once for each question and zone: what the peers prepare is made here.
  bool ask(Question question, const Subject& subject) {
    const std::size_t count = effort_.zone_places;
    std::vector<GridPlace> places = uniform_places(subject.outline, count, 7);
    const std::vector<GridPlace> near = near_places(subject.outline, near_mm, count, 8);
    places.insert(places.end(), near.begin(), near.end());
    const std::vector<GridPlace> way = way_places(subject.outline, near_mm, step_mm, count, 10);
    places.insert(places.end(), way.begin(), way.end());
    if (question == Question::leg) places = legs_from(places, leg_mm, 9);
    const std::vector<Contender> all = contenders(question, subject, places);
    report_.section(std::string(question_titles[std::size_t(question)]));
    bool good = true;
    for (std::size_t kind = 0; kind < places_of.size(); ++kind) {
      const std::size_t first = kind * count;
      good = same_answers(question, kind, subject, all, first, count) && good;
      const std::size_t best = time(question, kind, subject, all, first, count);
      const bool grows = kind < 2 && subject.shape == std::string("coast") && subject.generated &&
                         (subject.vertices == 100 || subject.vertices == 100'000);
      if (grows && best < all.size()) {
        cached(question, kind, subject, {all[0], all[best]}, first, count);
        cold(question, kind, subject, {all[0], all[best]}, first);
      }
    }
    return good;
  }

  // The cost at 100,000 vertices over that at 100.
  void add_growth() {
    report_.section("Zones: cost at 100,000 vertices over that at 100");
    for (const Kept& small : kept_) {
      for (const Kept& large : kept_) {
        if (small.vertices == 100 && large.vertices == 100'000 && small.what == large.what) {
          report_.add("growth_" + small.key, small.what, large.ns / small.ns, "x", 2);
        }
      }
    }
  }

 private:
  struct Kept {
    std::string what, key;
    std::size_t vertices;
    double ns;
  };

  void keep_for_growth(Question question, const Subject& subject, std::size_t kind,
                       const std::string& caches, double ns) {
    const std::string asked = question_keys[std::size_t(question)];
    const std::string shape = subject.shape, places = places_of[kind];
    const bool any = caches.empty();
    kept_.push_back({asked + ", " + shape + ", " + places + (any ? "" : ", " + caches),
                     asked + "_" + shape + "_" + places + (any ? "" : "_" + caches),
                     subject.vertices, ns});
  }

  static bool same_answers(Question question, std::size_t kind, const Subject& subject,
                           const std::vector<Contender>& all, std::size_t first,
                           std::size_t count) {
    if (!subject.generated) return true;
    const double ours = all[0].ask(first, first + count);
    bool good = true;
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (!all[i].is_comparable) continue;
      const double theirs = all[i].ask(first, first + count);
      if (agree(question, kind > 0, ours, theirs, count)) continue;
      std::fprintf(stderr, "rtac_bench: %s, %s, %s: %.0f, but %s says %.0f\n",
                   subject.title().c_str(), question_keys[std::size_t(question)], places_of[kind],
                   ours, all[i].name.c_str(), theirs);
      good = false;
    }
    return good;
  }

  // A pass asks about all places, or about the next ones that it has the time for, so many at once.
  [[nodiscard]] std::function<double()> pass_of(const Contender& c, std::size_t first,
                                                std::size_t count, std::size_t batch) const {
    c.ask(first, first + 1);  // some prepare when they are asked for the first time
    const std::size_t few = std::min<std::size_t>(count, 100);
    const double fit = effort_.zone_pass_ms * 1e6 / std::max(ask_ns(c, first, first + few), 1.0);
    const std::size_t share = std::clamp(static_cast<std::size_t>(fit), few, count);
    return [&c, first, count, share, batch, next = std::size_t{0}]() mutable {
      const std::size_t from = first + next, end = from + share;
      next = next + 2 * share <= count ? next + share : 0;
      double ns = 0;
      for (std::size_t at = from; at < end; at += batch) {
        const std::size_t to = std::min(at + batch, end);
        ask_ns(c, at, to);  // warms the caches
        ns += ask_ns(c, at, to) * static_cast<double>(to - at);
      }
      return ns / static_cast<double>(share);
    };
  }

  static double ask_ns(const Contender& c, std::size_t first, std::size_t end) {
    const auto from = std::chrono::steady_clock::now();
    const double sum = c.ask(first, end);
    const auto to = std::chrono::steady_clock::now();
    keep(&sum);
    return std::chrono::duration<double, std::nano>(to - from).count() /
           static_cast<double>(end - first);
  }

  // Returns the best peer that answers the same; those that answer less have rows of their own.
  std::size_t time(Question question, std::size_t kind, const Subject& subject,
                   const std::vector<Contender>& all, std::size_t first, std::size_t count) {
    Contest contest;
    for (const Contender& c : all) contest.add(pass_of(c, first, count, count));
    contest.run(effort_.zone_rounds, 3);
    const std::size_t peers = subject.generated ? 1 : 0;
    std::size_t best = all.size();
    for (std::size_t i = peers; i < all.size(); ++i) {
      if (!all[i].is_comparable) continue;
      if (best == all.size() || contest.tick_ns(i).median < contest.tick_ns(best).median) best = i;
    }
    const std::string what = subject.title() + ", " + places_of[kind];
    const std::string end = std::string(question_keys[std::size_t(question)]) + "_" +
                            subject.key() + "_" + places_of[kind];
    if (subject.generated) {
      report_.add("zone_ns_" + end, what + ": rtac", contest.tick_ns(0), "ns", 1);
      keep_for_growth(question, subject, kind, "", contest.tick_ns(0).median);
    }
    if (best < all.size()) {
      report_.add("zone_peer_ns_" + end, "  best peer: " + all[best].name, contest.tick_ns(best),
                  "ns", 1);
      if (subject.generated) {
        report_.add("zone_ratio_" + end, "  its time over that of rtac", contest.ratio(best, 0),
                    "x", 1);
      }
    }
    for (std::size_t i = peers; i < all.size(); ++i) {
      if (all[i].is_comparable) continue;
      report_.add("zone_less_ns_" + end + "_" + std::to_string(i), "  for less: " + all[i].name,
                  contest.tick_ns(i), "ns", 1);
    }
    return best;
  }

  void cached(Question question, std::size_t kind, const Subject& subject,
              const std::array<Contender, 2>& two, std::size_t first, std::size_t count) {
    Contest contest;
    for (const Contender& c : two) contest.add(pass_of(c, first, count, batch_places));
    contest.run(effort_.zone_rounds, 3);
    for (std::size_t i = 0; i < two.size(); ++i) {
      report_.add(std::string("zone_cached_") + (i == 0 ? "" : "peer_") +
                      question_keys[std::size_t(question)] + "_" + subject.key() + "_" +
                      places_of[kind],
                  "  cached: " + two[i].name, contest.tick_ns(i), "ns", 1);
    }
    keep_for_growth(question, subject, kind, "cached", contest.tick_ns(0).median);
  }

  void cold(Question question, std::size_t kind, const Subject& subject,
            const std::array<Contender, 2>& two, std::size_t first) {
    if (clock_ns_ == 0) clock_ns_ = clock_alone();
    for (const Contender& c : two) {
      std::vector<double> times;
      for (int i = 0; i < effort_.zone_cold_questions; ++i) {
        const std::size_t at = first + static_cast<std::size_t>(i);
        times.push_back(once([&] { return c.ask(at, at + 1); }) - clock_ns_);
      }
      const bool ours = &c == two.data();
      const Spread found = spread_of(times);
      report_.add(std::string("zone_cold_") + (ours ? "" : "peer_") +
                      question_keys[std::size_t(question)] + "_" + subject.key() + "_" +
                      places_of[kind],
                  "  cold: " + c.name, found, "ns", 0);
      if (ours) keep_for_growth(question, subject, kind, "cold", found.median);
    }
  }

  double clock_alone() {
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) times.push_back(once([] { return 0.0; }));
    return spread_of(times).median;
  }
  // One question with cold caches, with the clock.
  template <class Ask>
  double once(const Ask& ask) {
    if (walked_.empty()) walked_.assign(last_cache_bytes() / sizeof(std::uint64_t), 1);
    for (std::size_t i = 0; i < walked_.size(); i += 8) walked_[i] += i;  // one for each line
    const auto from = std::chrono::steady_clock::now();
    const double answer = ask();
    const auto to = std::chrono::steady_clock::now();
    keep(&answer);
    return std::chrono::duration<double, std::nano>(to - from).count();
  }
  static std::size_t last_cache_bytes() {
    constexpr long least = 64 << 20, most = 512 << 20;
    return static_cast<std::size_t>(std::clamp(sysconf(_SC_LEVEL3_CACHE_SIZE), least, most));
  }

  const Effort& effort_;
  Report& report_;
  std::vector<Kept> kept_;
  std::vector<std::uint64_t> walked_;
  double clock_ns_ = 0;  // with cold caches
};

}  // namespace

bool measure_zones(const Effort& effort, Report& report) {
  QueryBench bench(effort, report);
  std::vector<Subject> subjects;
  bool good = true;
  const auto add = [&](const char* shape, Fence (*make)(std::size_t, Vertices, std::uint64_t),
                       std::size_t vertices) {
    Subject subject{shape, vertices, outline_of(shape, make(vertices, Vertices::on_grid, 1)),
                    nullptr};
    std::string problem;
    subject.generated = generate(subject.outline, problem);
    if (!subject.generated) {
      std::fprintf(stderr, "rtac_bench: %s: %s\n", subject.title().c_str(), problem.c_str());
      good = false;
    }
    subjects.push_back(std::move(subject));
  };
  for (const std::size_t vertices : {10, 100, 1'000, 10'000, 100'000}) {
    add("coast", coast, vertices);
  }
  if (effort.zone_shapes > 1) add("circle", circle_fence, 1'000);
  if (effort.zone_shapes > 2) add("star", mild_star, 1'000);
  for (const Question question : {Question::inside, Question::clearance, Question::leg}) {
    for (const Subject& subject : subjects) good = bench.ask(question, subject) && good;
  }
  bench.add_growth();
  return good;
}

}  // namespace rtac::bench
