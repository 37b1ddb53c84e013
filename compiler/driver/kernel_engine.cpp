#include "compiler/driver/kernel_engine.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#include "compiler/driver/held_zone.h"
#include "compiler/driver/shared_object.h"

namespace rtac::driver {
namespace {

// The layout that every kernel of plain monitors has: its inputs are such samples, of words of 64
// bits. What is said in words of 32 bits, `valid` and then `between`, fills whole ones; numbers
// follow. Of a path it is `valid`, the number of its way-points and the next one; x, then y.
class Sample {
 public:
  explicit Sample(const KernelInterface::Input& input)
      : flags_(input.is_path() ? 2 : (1 + (input.numbers() + bits - 1) / bits + 1) / 2),
        words_(1 + flags_ + input.numbers(), 0) {
    words_[0] = std::numeric_limits<std::int64_t>::min();
  }
  [[nodiscard]] const std::vector<std::int64_t>& words() const { return words_; }
  // Nothing is known of its numbers yet.
  void arrive(std::int64_t stamp_us, bool valid) {
    std::fill(words_.begin(), words_.end(), 0);
    words_[0] = stamp_us;
    set_flag(0, valid ? 1 : 0);
  }
  void put(std::size_t component, const interp::Reading& reading, const Rational& step) {
    std::int64_t& number = words_[1 + flags_ + component];
    number = std::numeric_limits<std::int64_t>::min();
    if (reading.kind != interp::Reading::Kind::number) return;
    const auto grid = reading.number.on_grid(step);
    number = std::max(grid.lo, number + 1);  // it is finite
    if (grid.hi > grid.lo) set_flag(1 + component / bits, 1U << (component % bits));
  }

  void lead(const std::vector<interp::Waypoint>& points, std::uint32_t next) {
    const std::size_t most = (words_.size() - 1 - flags_) / 2;
    set_flag(1, static_cast<std::uint32_t>(points.size()));
    set_flag(2, next);
    for (std::size_t i = 0; i < points.size(); ++i) {
      words_[1 + flags_ + i] = points[i].x_mm;
      words_[1 + flags_ + most + i] = points[i].y_mm;
    }
  }

 private:
  static constexpr std::size_t bits = 32;
  // The words of 32 bits, in the order of memory.
  void set_flag(std::size_t word, std::uint32_t value) {
    auto* const at = reinterpret_cast<unsigned char*>(words_.data() + 1) + word * sizeof value;
    std::uint32_t now = 0;
    std::memcpy(&now, at, sizeof now);
    now |= value;
    std::memcpy(at, &now, sizeof now);
  }

  std::size_t flags_;
  std::vector<std::int64_t> words_;
};
struct KernelFinding {
  std::int32_t verdict, reason, input, unit;
  std::int64_t lo, hi;
};

// Compiled with the kernel: the names of a kernel depend on the specification, these do not.
std::string glue(const KernelInterface& kernel) {
  const std::string& p = kernel.prefix;
  std::string up = p;
  for (char& c : up) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return "#include \"" + kernel.source + "\"\n" +
         "const int64_t rtac_replay_sizes[] = {(int64_t)sizeof(" + p +
         "_monitors_in), (int64_t)sizeof(" + p + "_monitors_state), (int64_t)sizeof(" + p +
         "_monitors_out)};\n" +  //
         "const int64_t rtac_replay_values[] = {" + up + "_VERDICT_TRUE, " + up +
         "_VERDICT_FALSE, MARGIN_MAX / 2};\n" +  //
         "void rtac_replay_init(void *state) {\n  " + p + "_monitors_init((" + p +
         "_monitors_state *)state);\n}\n" +  //
         "void rtac_replay_step(void *state, const void *in, int64_t now_us, void *out) {\n  " + p +
         "_monitors_step((" + p + "_monitors_state *)state, (const " + p +
         "_monitors_in *)in, now_us, (" + p + "_monitors_out *)out);\n}\n";
}

struct Sizes {
  std::int64_t in, state, out;
};
struct Values {
  std::int64_t verdict_true, verdict_false, margin_max;
};
using Init = void (*)(void*);
using Step = void (*)(void*, const void*, std::int64_t, void*);

// Margins as decimal numbers: the factor of a unit is a power of ten nearly always, and then it is
// a matter of putting the point.
class MarginText {
 public:
  explicit MarginText(const Rational& factor) : factor_(factor) {
    for (Rational rest = factor; places_ < places_max && rest.get_den() != 1; ++places_) rest *= 10;
    Rational scaled = factor;
    for (unsigned i = 0; i < places_; ++i) scaled *= 10;
    is_short_ = scaled == 1;
  }
  void print(std::int64_t margin, std::string& to) const {
    if (!is_short_) {
      to = text_of_margin(Rational(factor_ * Rational(static_cast<long>(margin))));
      return;
    }
    to.clear();
    std::uint64_t rest =
        margin < 0 ? 0 - static_cast<std::uint64_t>(margin) : static_cast<std::uint64_t>(margin);
    bool significant = false;  // zeros at the end of the fraction are left out
    for (unsigned place = 0; place < places_ || rest > 0 || place == places_; ++place) {
      if (place == places_ && significant) to += '.';
      const auto digit = static_cast<char>('0' + rest % 10);
      rest /= 10;
      significant = significant || digit != '0';
      if (significant || place >= places_) to += digit;
    }
    if (margin < 0) to += '-';
    std::reverse(to.begin(), to.end());
  }

 private:
  static constexpr unsigned places_max = 9;  // as text_of_margin
  Rational factor_;
  unsigned places_ = 0;
  bool is_short_ = false;
};

class KernelEngine : public Engine {
 public:
  KernelEngine(SharedObject library, const KernelInterface& kernel)
      : library_(std::move(library)),
        sizes_(*library_.data<const Sizes>("rtac_replay_sizes")),
        values_(*library_.data<const Values>("rtac_replay_values")),
        step_(library_.function<Step>("rtac_replay_step")),
        kernel_(kernel) {
    forget_samples();
    for (const Sample& sample : samples_) words_of_samples_ += sample.words().size();
    for (const auto& unit : kernel.units) margins_.emplace_back(unit.factor);
  }
  // Empty when the kernel has the layout that this engine is made for.
  [[nodiscard]] std::string problem() const {
    // what has no inputs has a member that says so
    const std::size_t in =
        std::max<std::size_t>((words_of_samples_ + kernel_.params.size()) * sizeof(std::int64_t) +
                                  kernel_.zones.size() * sizeof(HeldZone::Zone),
                              sizeof(std::int32_t));
    const std::size_t out = sizeof(std::int64_t) + kernel_.monitors * sizeof(KernelFinding);
    const auto same = [](std::int64_t a, std::size_t b) {
      return a == static_cast<std::int64_t>(b);
    };
    const bool as_due = same(sizes_.in, in) && same(sizes_.out, out);
    return as_due ? "" : "the generated kernel has another layout than its interface says";
  }
  // False: there is no room for what the monitors remember.
  [[nodiscard]] bool start() {
    try {
      state_.resize(words(sizes_.state));
      in_.resize(words(sizes_.in));
      out_.resize(words(sizes_.out));
    } catch (const std::bad_alloc&) {
      return false;
    }
    restart();
    return true;
  }
  [[nodiscard]] std::int64_t state_bytes() const { return sizes_.state; }
  void restart() override {
    for (std::size_t k = 0; k < kernel_.params.size(); ++k) param(k) = kernel_.params[k].value;
    forget_samples();
    held_.assign(kernel_.zones.size(), {});
    library_.function<Init>("rtac_replay_init")(state_.data());
  }

  void step(std::int64_t now_us, const std::vector<Observed>& inputs,
            std::vector<Judgement>& judgements) override {
    std::size_t component = 0;
    auto to = in_.begin();
    for (std::size_t i = 0; i < samples_.size(); component += kernel_.inputs[i].components, ++i) {
      take(inputs, component, kernel_.inputs[i], samples_[i]);
      to = std::copy(samples_[i].words().begin(), samples_[i].words().end(), to);
    }
    for (std::size_t k = 0; k < held_.size(); ++k) {
      const std::size_t i = kernel_.zones[k];
      const Observed& input = inputs[kernel_.components.empty() ? i : kernel_.components[i]];
      if (input.is_new && input.reading.zone) put_zone(k, input.reading.zone);
    }
    step_(state_.data(), in_.data(), now_us, out_.data());
    judgements.resize(kernel_.monitors);
    for (std::size_t k = 0; k < judgements.size(); ++k) report(finding(k), judgements[k]);
  }
  [[nodiscard]] MarginEnds margin(std::size_t monitor) const override {
    const KernelFinding found = finding(monitor);
    const auto end = [&](std::int64_t millionths) {
      if (std::abs(millionths) >= values_.margin_max) {
        return interp::Extended::infinity(millionths < 0 ? -1 : 1);
      }
      return interp::Extended(unit(found).factor * Rational(static_cast<long>(millionths)));
    };
    return {end(found.lo), end(found.hi)};
  }
  // As the generated class does it: between two steps of the grid the tighter one counts, and what
  // is looser than before or out of range does not.
  void set_param(std::size_t k, const Rational& value) override {
    const KernelInterface::Param& of = kernel_.params[k];
    const Rational steps = value / of.step;
    if (!fits_int64(steps)) return;
    const bool up = of.tightens > 0;
    const std::int64_t given = up ? ceil_to_int(steps) : floor_to_int(steps);
    if (given < of.least || given > of.most) return;
    param(k) = up ? std::max(param(k), given) : std::min(param(k), given);
  }

 private:
  static std::size_t words(std::int64_t bytes) {
    return (static_cast<std::size_t>(bytes) + sizeof(std::int64_t) - 1) / sizeof(std::int64_t);
  }
  void forget_samples() {
    samples_.clear();
    for (const KernelInterface::Input& input : kernel_.inputs) {
      samples_.emplace_back(input);
    }
  }
  // Way-points, x before y, and the next one.
  static void take_path(const Observed& path, const Observed& index, Sample& to) {
    const bool known =
        path.reading.path != nullptr && index.reading.kind == interp::Reading::Kind::number;
    to.arrive(path.stamp_us, known);
    if (!known) return;
    const auto next = index.reading.number.on_grid(1).lo;
    constexpr std::int64_t none = std::numeric_limits<std::int32_t>::max();
    to.lead(*path.reading.path, static_cast<std::uint32_t>(next < 0 || next > none ? none : next));
  }
  // The components of an input arrive together; the tables of a zone are beside its sample.
  void take(const std::vector<Observed>& inputs, std::size_t first,
            const KernelInterface::Input& input, Sample& to) const {
    const auto at = [&](std::size_t k) -> const Observed& {
      return inputs[kernel_.components.empty() ? first + k : kernel_.components[first + k]];
    };
    if (!at(0).is_new) return;
    if (input.is_path()) {
      const std::size_t path = kernel_.components.empty() ? first : kernel_.components[first];
      return take_path(inputs[path], inputs[path + 1], to);
    }
    to.arrive(at(0).stamp_us, !input.is_zone || at(0).reading.zone != nullptr);
    for (std::size_t k = 0; k < input.numbers(); ++k) {
      to.put(k, at(k).reading, kernel_.steps[first + k]);
    }
  }
  void put_zone(std::size_t k, const std::shared_ptr<const interp::ReceivedZone>& received) {
    held_[k].hold(received);
    const HeldZone::Zone& zone = held_[k].zone();
    const std::size_t at =
        words_of_samples_ + kernel_.params.size() + k * sizeof zone / sizeof(std::int64_t);
    std::memcpy(in_.data() + at, &zone, sizeof zone);
  }
  std::int64_t& param(std::size_t k) { return in_[words_of_samples_ + k]; }
  [[nodiscard]] KernelFinding finding(std::size_t monitor) const {
    KernelFinding found;
    std::memcpy(&found, out_.data() + 1 + monitor * sizeof found / sizeof(std::int64_t),
                sizeof found);
    // rule 4.4: what is infinite has no unit, and 0 is that of truth values
    if (std::abs(found.lo) >= values_.margin_max) found.unit = 0;
    return found;
  }
  [[nodiscard]] const KernelInterface::Unit& unit(const KernelFinding& finding) const {
    return kernel_
        .units[std::min(static_cast<std::size_t>(finding.unit), kernel_.units.size() - 1)];
  }
  void report(const KernelFinding& finding, Judgement& judgement) const {
    judgement.verdict = interp::Verdict::unknown;
    if (finding.verdict == values_.verdict_true) judgement.verdict = interp::Verdict::yes;
    if (finding.verdict == values_.verdict_false) judgement.verdict = interp::Verdict::no;
    const auto unit = std::min(static_cast<std::size_t>(finding.unit), kernel_.units.size() - 1);
    judgement.unit = kernel_.units[unit].text;
    if (finding.lo >= values_.margin_max) {
      judgement.margin = "inf";
    } else if (finding.lo <= -values_.margin_max) {
      judgement.margin = "-inf";
    } else {
      margins_[unit].print(finding.lo, judgement.margin);
    }
  }

  SharedObject library_;
  Sizes sizes_;
  Values values_;
  Step step_;
  KernelInterface kernel_;
  std::vector<MarginText> margins_;
  std::vector<Sample> samples_;
  std::vector<HeldZone> held_;
  std::size_t words_of_samples_ = 0;
  std::vector<std::int64_t> state_, in_, out_;  // aligned as the kernel's structs
};

}  // namespace

LoadedKernel load_kernel(const std::vector<OutputFile>& files, const KernelInterface& kernel) {
  BuiltObject built = build_object(files, glue(kernel));
  if (!built.object) return {nullptr, built.problem};
  auto engine = std::make_unique<KernelEngine>(std::move(*built.object), kernel);
  if (std::string problem = engine->problem(); !problem.empty()) return {nullptr, problem, true};
  if (!engine->start()) {
    return {nullptr, "the monitors remember " + std::to_string(engine->state_bytes()) +
                         " bytes, which this machine cannot give"};
  }
  return {std::move(engine), ""};
}

}  // namespace rtac::driver
