// A bounded first-in first-out queue of events. It never allocates; a full queue refuses, so that
// an overload is seen where it happens instead of growing.
#pragma once

#include <array>
#include <cstddef>

#include "rtac/status.h"

namespace rtac {

template <class Event, std::size_t Capacity>
class EventQueue {
  static_assert(Capacity > 0, "a queue without room carries nothing");

 public:
  static constexpr std::size_t capacity = Capacity;

  Status push(const Event& event) {
    if (size_ == Capacity) return Status::full;
    events_[(first_ + size_) % Capacity] = event;
    ++size_;
    return Status::ok;
  }
  // The oldest event; valid only while the queue is not empty.
  [[nodiscard]] const Event& front() const { return events_[first_]; }
  void pop() {
    if (size_ == 0) return;
    first_ = (first_ + 1) % Capacity;
    --size_;
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::array<Event, Capacity> events_{};
  std::size_t first_ = 0, size_ = 0;
};

}  // namespace rtac
