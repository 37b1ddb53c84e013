// How a watch sees a tick: the view of its inputs, what a missed tick sees, and one function for
// each input that looks at its newest sample. The same for monitors without a robot, with margins
// and for verdicts alone, and for the facts of a decision.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/codegen/repeat_printer.h"
#include "compiler/codegen/watch.h"
#include "compiler/codegen/watch_values.h"

namespace rtac::codegen {

class WatchLook {
 public:
  WatchLook(WatchKernel kernel, std::set<std::string>& uses, Code& out);

  void view();   // the type
  void blind();  // _blind(v, s): nothing is known of the inputs
  // Some monitors are told at a glance: of these inputs. They ask only whether a sample counts, and
  // see its numbers when they look closely; others see them in every tick.
  void glance_at(std::vector<bool> at_a_glance, std::vector<bool> always) {
    at_a_glance_ = std::move(at_a_glance);
    always_ = std::move(always);
  }
  void channels();  // _look_...(v, in), for each input that is used
  // The statement that sees the numbers of an input; `fresh`: whether its sample counts.
  [[nodiscard]] std::string see(std::size_t channel, const std::string& view, const std::string& in,
                                const std::string& fresh) const;
  // The statement that looks at an input; `view`, `in`: pointers.
  [[nodiscard]] std::string call(std::size_t channel, const std::string& view,
                                 const std::string& in) const;
  // Which zones are there now; `view`: what leads to its members.
  void schedules(const std::string& view, Code& body) const;
  // The newest parameters; `state`, `in`: what leads to the members.
  void params(const std::string& state, const std::string& in, Code& body) const;
  // The body of the function of a property; false: it does not look at the view.
  bool property(const ir::Block& block, WatchValuePrinter& values, Code& body,
                RepeatPrinter* repeats = nullptr);
  // Starts what is remembered: no sample was seen, parameters have their first values.
  void start(const std::string& state, Code& body) const;
  // All before `tick` is unknown.
  void forget(const std::string& state, const std::string& tick, Code& body) const;
  // Behind the calls of a tick.
  void next_tick(const std::string& state, Code& body) const;
  // `start(`, the parameters, the body.
  void function(const std::string& start, const std::vector<std::string>& parameters,
                const std::function<void(Code&)>& body);

  [[nodiscard]] const WatchKernel& kernel() const { return kernel_; }
  [[nodiscard]] const WatchNames& members() const { return members_; }
  // Whether a sample counts is told by its stamp and that of the last tick alone, and nothing else
  // is asked of it but its numbers; and how it is told.
  [[nodiscard]] bool is_plain(std::size_t channel) const;
  std::string arrived(std::size_t channel);
  [[nodiscard]] std::string valid(std::size_t channel) const {
    return "in->" + sample(channel) + ".valid";
  }
  [[nodiscard]] bool is_used(std::size_t channel) const { return asked_.used[channel]; }
  [[nodiscard]] const std::string& view_type() const { return view_; }

 private:
  [[nodiscard]] bool is_truth(std::size_t channel) const;
  [[nodiscard]] bool is_zone(std::size_t channel) const;
  [[nodiscard]] bool is_path(std::size_t channel) const;
  [[nodiscard]] std::string truth_type() const { return kernel_.is_full() ? "margin" : "int32_t"; }
  [[nodiscard]] std::string type_of(std::size_t channel) const;
  void channel(std::size_t index, Code& out);
  void numbers(std::size_t index, Code& out);
  [[nodiscard]] bool is_at_a_glance(std::size_t channel) const {
    return !at_a_glance_.empty() && at_a_glance_[channel];
  }
  std::string fresh(std::size_t index, const std::string& first, Code& out);
  std::string whole_sample(std::size_t index, Code& out);
  [[nodiscard]] bool is_seen_whole(std::size_t channel) const;
  void whole(std::size_t index, Code& out);
  void component(std::size_t index, std::uint32_t k, Code& body);
  [[nodiscard]] std::string sample(std::size_t channel) const { return members_.samples[channel]; }
  [[nodiscard]] std::string number(std::size_t channel, std::uint32_t k) const;
  std::string unknown(bool is_truth);
  std::string use(const std::string& function, const std::string& arguments);

  const WatchKernel kernel_;
  const ir::Watch& watch_;
  const WatchNames members_;
  const ChannelUses asked_;
  const std::vector<bool> needed_whole_;    // by channel
  std::vector<bool> at_a_glance_, always_;  // by channel; empty: always
  const std::string view_, clock_;
  std::set<std::string>& uses_;
  Code& out_;
};

}  // namespace rtac::codegen
