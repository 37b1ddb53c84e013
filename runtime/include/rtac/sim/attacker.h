// Advanced controllers that know everything and want a property to fail.
#pragma once

#include "rtac/controller.h"
#include "rtac/sim/adversary.h"
#include "rtac/sim/arena.h"
#include "rtac/sim/random.h"

namespace rtac::sim {

// Whether an attack only ever pushes, or tries everything in turn.
enum class Manner { in_phases, only_pushes };

// Full effort towards where the margin falls fastest, in phases by seed: at once; after a run-up,
// or along the boundary at full speed; or creeping up to where the decision only just still
// agrees, and then at full effort, so that a whole tick is lost at the worst moment. Or always at
// once, which tells how much of the time a decision leaves to whoever wants the worst of it.
template <class Output>
class Chase final : public Controller<Output> {
 public:
  // The arena outlives the controller.
  Chase(const Arena& arena, int robot, Aim aim, std::uint64_t seed,
        Manner manner = Manner::in_phases);
  Output command(const Observation& observation) override;

 private:
  enum class Phase { push, run_up, slide, creep };
  void choose(TimeUs now_us);
  [[nodiscard]] Vec3 wanted(const Threat& threat, bool& all_out);

  const Arena& arena_;
  int robot_;
  Aim aim_;
  Manner manner_;
  Random random_;
  Phase phase_ = Phase::push;
  TimeUs until_us_ = never_us;
  double side_ = 1;     // of sliding
  double burst_m_ = 0;  // spare look-ahead at which creeping ends
};

extern template class Chase<Acceleration>;
extern template class Chase<Twist>;

}  // namespace rtac::sim
