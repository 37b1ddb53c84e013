// Event-driven machines and the executive that runs them: one event at a time, in a fixed order,
// until nothing is left to do. No threads, so that a run is a function of its inputs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rtac/queue.h"
#include "rtac/types.h"

namespace rtac {

class MachineBase {
 public:
  virtual ~MachineBase() = default;
  // Handles the oldest event; false when there was none.
  virtual bool step() = 0;
  // Events refused because the queue was full; anything but 0 is a defect of the wiring.
  [[nodiscard]] virtual std::uint64_t dropped() const = 0;
};

template <class Event, std::size_t Capacity>
class Machine : public MachineBase {
 public:
  void post(const Event& event) {
    if (queue_.push(event) != Status::ok) ++dropped_;
  }
  bool step() final {
    if (queue_.empty()) return false;
    // A handler may post to its own machine, so the event leaves the queue first.
    current_ = queue_.front();
    queue_.pop();
    handle(current_);
    return true;
  }
  [[nodiscard]] std::uint64_t dropped() const final { return dropped_; }

 protected:
  virtual void handle(const Event& event) = 0;

 private:
  EventQueue<Event, Capacity> queue_;
  Event current_{};
  std::uint64_t dropped_ = 0;
};

class Executive {
 public:
  static constexpr std::size_t max_machines = 1 + 3 * max_robots;

  Status add(MachineBase& machine) { return machines_.push(&machine) ? Status::ok : Status::full; }
  // Rounds over all machines in the order of `add`, one event each, until all queues are empty.
  // Status::full: more than `max_rounds` rounds, which means that machines keep each other busy.
  Status run_until_quiescent(int max_rounds = 1000) {
    for (int round = 0; round < max_rounds; ++round) {
      bool busy = false;
      for (MachineBase* machine : machines_) busy = machine->step() || busy;
      if (!busy) return Status::ok;
    }
    return Status::full;
  }

 private:
  FixedList<MachineBase*, max_machines> machines_;
};

}  // namespace rtac
