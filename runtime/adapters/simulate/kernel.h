// A compiled kernel as the decision modules of the runtime.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "case.h"
#include "rtac/decision.h"

namespace rtac::simulate {

class Kernel {
 public:
  Kernel() = default;
  ~Kernel();
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  Problem load(const std::string& path);

  using Init = void (*)(void*);
  using Step = void (*)(void*, const std::int64_t*, std::int64_t, std::int64_t*);
  struct Functions {
    std::size_t state_bytes = 0, in_words = 0, out_words = 0;
    Init init = nullptr;
    Step step = nullptr;
    TimeUs jitter_us = 0;  // a step comes so much later than due at most
  };
  Problem find(const DecisionCase& decision, Functions& to) const;

 private:
  [[nodiscard]] void* symbol(const std::string& name) const;
  void* handle_ = nullptr;
};

// What the clock of a kernel shows where nothing depends on it: no sample is older than that.
inline constexpr TimeUs early_us = 1'000'000'000;

// The newest sample that a robot has of an agent.
using SeesAgent = std::function<Sample<Vec3>(int robot, int agent, TimeUs now_us)>;

// One decision for one robot. Everything that it is made with outlives it.
class KernelDecision final : public DecisionModule {
 public:
  // `begins_us`: what the clock of the kernel shows at time 0.
  KernelDecision(const Kernel::Functions& functions, const DecisionCase& decision, int self,
                 SeesAgent sees, TimeUs begins_us);
  [[nodiscard]] const DecisionInfo& info() const override { return info_; }
  const DecisionRecord& step(const Observation& observation, bool holding, bool surrender) override;
  void reset() override;

 private:
  void take(TimeUs now_us);
  // Of a moment of the run, or of none; and back.
  [[nodiscard]] TimeUs shown(TimeUs at_us) const {
    return at_us == never_us ? never_us : at_us + begins_us_;
  }
  template <class Value>
  [[nodiscard]] Sample<Value> shown(Sample<Value> sample) const {
    sample.stamp_us = shown(sample.stamp_us);
    return sample;
  }

  const Kernel::Functions& functions_;
  std::size_t capacity_, agents_;
  SeesAgent sees_;
  TimeUs begins_us_;
  std::vector<MonitorInfo> monitors_;
  DecisionInfo info_;
  std::vector<std::int64_t> state_, in_, out_;
  DecisionRecord record_;
};

}  // namespace rtac::simulate
