#include "kernel.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>

#include "kernel_words.h"
#include "rtac/kernel_bridge.h"

namespace rtac::simulate {
namespace {

template <class F>
F function_of(void* symbol) {
  F function{};
  static_assert(sizeof function == sizeof symbol);  // POSIX: dlsym serves functions too
  std::memcpy(&function, &symbol, sizeof function);
  return function;
}

// `height`: in the plane 0.
void put(const Sample<Vec2>& sample, double height, std::int64_t* to) {
  struct {
    std::int64_t x_lo = 0, x_hi = 0, y_lo = 0, y_hi = 0, stamp_us = 0, valid = 0, z_lo = 0,
                 z_hi = 0;
  } point;
  bridge::put_in_space(point, sample, height);
  const std::int64_t all[] = {point.x_lo,     point.x_hi,  point.y_lo, point.y_hi,
                              point.stamp_us, point.valid, point.z_lo, point.z_hi};
  std::copy(std::begin(all), std::end(all), to);
}

// In steps of the grid.
void put(const Sample<double>& sample, double per_unit, std::int64_t* to) {
  to[2] = sample.stamp_us;
  to[3] = sample.stamp_us != never_us && bridge::grid_pair(sample.value, per_unit, to[0], to[1]);
}

void put(const Path& path, std::size_t capacity, std::int64_t* to) {
  struct {
    std::int64_t valid = 0;
    std::int32_t count = 0, index = 0;
    std::int64_t x[max_waypoints], y[max_waypoints];
  } plan;
  bridge::put(plan, path, std::min(capacity, max_waypoints));
  to[0] = plan.valid;
  to[1] = plan.count;
  to[2] = plan.index;
  if (plan.valid == 0) return;
  std::copy(plan.x, plan.x + plan.count, to + 3);
  std::copy(plan.y, plan.y + plan.count, to + 3 + capacity);
}

// Steps at or below the place, and whether it lies between two. It says that it is there.
void put_agent(const Sample<Vec3>& sample, TimeUs now_us, std::int64_t* to) {
  constexpr double steps_per_m = 1e3;
  std::int64_t x_hi = 0, y_hi = 0, z_hi = 0;
  to[3] = sample.stamp_us != never_us &&
          bridge::grid_pair(sample.value.x, steps_per_m, to[0], x_hi) &&
          bridge::grid_pair(sample.value.y, steps_per_m, to[1], y_hi) &&
          bridge::grid_pair(sample.value.z, steps_per_m, to[words::agent_z], z_hi);
  to[2] = (x_hi != to[0] ? 1 : 0) + (y_hi != to[1] ? 2 : 0) + (z_hi != to[words::agent_z] ? 4 : 0);
  to[4] = sample.stamp_us;
  to[words::agent_present] = to[words::agent_present + 1] = 1;
  to[words::agent_present + 2] = now_us;
}

std::size_t components_of(const DecisionCase& decision) {
  std::size_t count = 0;
  for (const Input& input : decision.inputs) count += input.components.size();
  return count;
}

// They are measured again in every tick, and always the same.
void put_inputs(const DecisionCase& decision, std::int64_t* to) {
  if (decision.measured.empty()) return;
  std::size_t k = 0;
  for (const Input& input : decision.inputs) {
    for (const Input::Component& c : input.components) {
      to[2] = bridge::grid_pair(decision.measured[k++], c.steps_per_unit, to[0], to[1]) ? 1 : 0;
      to += words::input_size;
    }
  }
}

constexpr double battery_steps = 1e6, heading_steps = 1e3;  // ppm, mrad

}  // namespace

Kernel::~Kernel() {
  if (handle_ != nullptr) ::dlclose(handle_);
}

void* Kernel::symbol(const std::string& name) const {
  return ::dlsym(handle_, name.c_str());
}

Problem Kernel::load(const std::string& path) {
  handle_ = ::dlopen(path.c_str(), RTLD_NOW);
  if (handle_ == nullptr) return {std::string("the kernel cannot be loaded: ") + ::dlerror(), ""};
  const auto* const version = static_cast<const std::int64_t*>(symbol("rtac_sim_words_version"));
  if (version != nullptr && *version == words::version) return {};
  return {"the kernel was compiled by another version of rtac",
          "install `rtac` and `rtac-sim` of the same version"};
}

Problem Kernel::find(const DecisionCase& decision, Functions& to) const {
  const std::string number = "_" + std::to_string(decision.number);
  const auto size = [&](const char* name) {
    const auto* const found = static_cast<const std::int64_t*>(symbol(name + number));
    return found == nullptr ? std::size_t{0} : static_cast<std::size_t>(*found);
  };
  to.state_bytes = size("rtac_sim_state_bytes");
  to.in_words = size("rtac_sim_in_words");
  to.out_words = size("rtac_sim_out_words");
  to.jitter_us = static_cast<TimeUs>(size("rtac_sim_jitter_us"));
  to.init = function_of<Init>(symbol("rtac_sim_init" + number));
  to.step = function_of<Step>(symbol("rtac_sim_step" + number));
  const std::size_t in = words::plan + words::plan_size(decision.plan_capacity) +
                         decision.robots.size() * words::other_size(decision.plan_capacity) +
                         decision.agents.size() * words::agent_size +
                         components_of(decision) * words::input_size;
  const std::size_t out = words::monitors + decision.monitors.size() * words::per_monitor;
  if (to.init != nullptr && to.step != nullptr && to.in_words == in && to.out_words == out) {
    return {};
  }
  return {"the kernel does not fit its manifest: decision `" + decision.name + "`", ""};
}

KernelDecision::KernelDecision(const Kernel::Functions& functions, const DecisionCase& decision,
                               int self, SeesAgent sees, TimeUs begins_us)
    : functions_(functions),
      capacity_(decision.plan_capacity),
      agents_(decision.agents.size()),
      sees_(std::move(sees)),
      begins_us_(begins_us),
      info_(),
      state_(functions.state_bytes / sizeof(std::int64_t) + 1),
      in_(functions.in_words),
      out_(functions.out_words) {
  for (const MonitorCase& m : decision.monitors) {
    monitors_.push_back({m.name.c_str(), m.requirement.c_str(), m.text.c_str(), "", 0,
                         m.recovery.name.c_str(), "", m.unit.c_str()});
  }
  info_.decision = decision.name.c_str();
  info_.kind = decision.kind.c_str();
  info_.advanced = decision.advanced.c_str();
  info_.safe = "";
  info_.monitors = monitors_.data();
  info_.monitor_count = static_cast<int>(monitors_.size());
  info_.period_us = decision.period_us;
  info_.limits = &decision.limits;
  info_.robot_count = static_cast<int>(decision.robots.size());
  info_.surrender_mode = decision.surrender_mode;
  info_.judges_commands = decision.judges_commands;
  in_[words::self] = self;
  put_inputs(decision, &in_[in_.size() - components_of(decision) * words::input_size]);
  reset();
}

void KernelDecision::reset() {
  functions_.init(state_.data());
  record_ = DecisionRecord();
  record_.info = &info_;
  record_.robot = static_cast<int>(in_[words::self]);
}

const DecisionRecord& KernelDecision::step(const Observation& seen, bool holding, bool surrender) {
  in_[words::holding] = holding ? 1 : 0;
  in_[words::surrender] = surrender ? 1 : 0;
  put(shown(seen.position), seen.height_m, &in_[words::position]);
  put(shown(seen.velocity), seen.climb_mps, &in_[words::velocity]);
  put(shown(seen.battery), battery_steps, &in_[words::battery]);
  put(shown(seen.heading), heading_steps, &in_[words::heading]);
  put(shown(seen.sent), seen.sent_up_mps2, &in_[words::sent]);
  put(shown(seen.proposed), seen.proposed_up_mps2, &in_[words::proposed]);
  put(seen.plan, capacity_, &in_[words::plan]);
  std::int64_t* other = &in_[words::plan] + words::plan_size(capacity_);
  for (int j = 0; j < info_.robot_count; ++j, other += words::other_size(capacity_)) {
    if (j == seen.self) continue;
    const Announcement& heard = seen.others[static_cast<std::size_t>(j)];
    put(shown(heard.position), heard.height_m, other + words::other_position);
    put(shown(heard.velocity), heard.climb_mps, other + words::other_velocity);
    other[words::lease_end] = shown(heard.lease_end_us);
    other[words::goes_first] = rtac::goes_first(seen, j) ? 1 : 0;
    other[words::presence] = shown(heard.present.stamp_us);
    other[words::present] = heard.present.value ? 1 : 0;
    put(heard.plan, capacity_, other + words::other_plan);
  }
  for (std::size_t k = 0; k < agents_; ++k, other += words::agent_size) {
    const Sample<Vec3> agent = sees_(seen.self, static_cast<int>(k), seen.now_us);
    put_agent(shown(agent), shown(seen.now_us), other);
  }
  functions_.step(state_.data(), in_.data(), shown(seen.now_us), out_.data());
  take(seen.now_us);
  return record_;
}

void KernelDecision::take(TimeUs now_us) {
  const auto whole = [&](std::size_t at) { return static_cast<int>(out_[at]); };
  record_.mode = whole(words::mode);
  record_.previous_mode = whole(words::previous_mode);
  record_.deciding_monitor = whole(words::deciding);
  record_.reason = static_cast<Reason>(out_[words::reason]);
  record_.reason_index = whole(words::reason_index);
  record_.reason_input = static_cast<InputField>(out_[words::reason_input]);
  record_.reason_other = whole(words::reason_other);
  record_.gate = static_cast<Gate>(out_[words::gate]);
  const TimeUs lease_end_us = out_[words::out_lease_end];
  record_.lease_end_us = lease_end_us == never_us ? never_us : lease_end_us - begins_us_;
  record_.time_to_violation_us = out_[words::violation];
  record_.tick = static_cast<std::uint64_t>(out_[words::tick]);
  record_.time_us = now_us;
  for (std::size_t k = 0; k < monitors_.size(); ++k) {
    const std::int64_t* const found = &out_[words::monitors + k * words::per_monitor];
    MonitorRecord& to = record_.monitors[k];
    to.now = static_cast<Verdict>(found[words::now]);
    to.ahead = static_cast<Verdict>(found[words::ahead]);
    to.safer = static_cast<Verdict>(found[words::safer]);
    to.engaged = found[words::engaged] != 0;
    to.margin = bridge::margin_of(found[words::margin]);
    to.unit = static_cast<MarginUnit>(found[words::unit]);
  }
}

}  // namespace rtac::simulate
