#include "compiler/codegen/closing_rate.h"

#include <algorithm>
#include <cstdlib>

namespace rtac::codegen {
namespace {

using namespace ir;

// Beyond it a rate tells nothing; sums of two still fit.
constexpr std::int64_t most_mmps = std::int64_t{1} << 40;

using Rate = std::optional<std::int64_t>;

class Rates {
 public:
  Rates(const Block& block, std::int64_t speed_mmps, const std::vector<Agent>& agents)
      : block_(block), agents_(agents), speed_mmps_(speed_mmps) {}
  [[nodiscard]] Rate of(ValueId id) const { return std::visit(*this, block_[id].op); }

  // quantities
  Rate operator()(const Const&) const { return 0; }
  Rate operator()(const ParamValue&) const { return 0; }  // as it is now
  Rate operator()(const Clearance&) const { return speed_mmps_; }
  Rate operator()(const Altitude&) const { return speed_mmps_; }
  Rate operator()(const Distance&) const { return 2 * speed_mmps_; }
  Rate operator()(const AgentDistance& v) const {
    return speed_mmps_ + agents_[static_cast<std::uint32_t>(v.agent)].speed_mmps;
  }
  Rate operator()(const Add& v) const { return sum(of(v.a), of(v.b)); }
  Rate operator()(const Negate& v) const { return of(v.a); }
  Rate operator()(const Scale& v) const {
    const Rate a = of(v.a);
    const std::int64_t factor = std::abs(v.num) / v.den + 1;
    if (!a || *a == 0) return a;
    return factor > most_mmps / *a ? Rate() : Rate(*a * factor);
  }
  // margins
  Rate operator()(const AtLeast& v) const { return sum(of(v.a), of(v.b)); }
  Rate operator()(const Truth&) const { return 0; }
  Rate operator()(const Not& v) const { return of(v.a); }
  Rate operator()(const And& v) const { return larger(of(v.a), of(v.b)); }
  Rate operator()(const Or& v) const { return larger(of(v.a), of(v.b)); }
  Rate operator()(const ForOthers& v) const {
    return Rates(*v.body, speed_mmps_, agents_).of(v.body->result);
  }
  // Neither charge nor what the past or a plan decides has a rate; the rest looks ahead and is no
  // part of a property.
  template <class Other>
  Rate operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  static Rate sum(Rate a, Rate b) {
    return a && b && *a + *b <= most_mmps ? Rate(*a + *b) : std::nullopt;
  }
  static Rate larger(Rate a, Rate b) { return a && b ? Rate(std::max(*a, *b)) : std::nullopt; }

  const Block& block_;
  const std::vector<Agent>& agents_;
  std::int64_t speed_mmps_;
};

}  // namespace

std::optional<std::int64_t> closing_mmps(const Block& property, std::int64_t speed_mmps,
                                         const std::vector<Agent>& agents) {
  const Rate rate = Rates(property, speed_mmps, agents).of(property.result);
  return rate && *rate > 0 ? rate : std::nullopt;
}

}  // namespace rtac::codegen
