// Where the thread that makes zones leaves the newest one for the thread that steps the monitors.
//
//   ZoneSlot slot;
//   slot.publish(std::move(zone), stamp_us);                              // any thread, at any
//   time slot.offer([&](const ZoneTable& t, TimeUs stamp_us) {                 // between two ticks
//     return monitors.fence(t, stamp_us);
//   });
//
// The one that steps never waits, allocates or frees: it takes the newest zone by one exchange, and
// hands back the one that it has left. A zone is freed by the thread that publishes the next one.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "rtac/zone_table.h"

namespace rtac {

// A table with its arrays; it stays as it is.
class HeldZone {
 public:
  struct Arrays {
    std::vector<std::int32_t> edges;
    std::vector<std::uint32_t> cells, lists;
  };
  // Counts and pointers of the outlines are those of the arrays. No arrays around: the same.
  HeldZone(ZoneOutline within, Arrays inner, ZoneOutline around, Arrays outer)
      : arrays_{std::move(inner), std::move(outer)} {
    table_.version = zone_table_version;
    table_.within = with_arrays(within, arrays_[0]);
    table_.around = arrays_[1].edges.empty() ? table_.within : with_arrays(around, arrays_[1]);
    table_.checksum = zone_checksum(table_);
  }
  HeldZone(const HeldZone&) = delete;
  HeldZone& operator=(const HeldZone&) = delete;

  [[nodiscard]] const ZoneTable& table() const { return table_; }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t numbers = 0;
    for (const Arrays& a : arrays_) numbers += a.edges.size() + a.cells.size() + a.lists.size();
    return 4 * numbers;
  }

 private:
  friend class ZoneSlot;
  static ZoneOutline with_arrays(ZoneOutline o, const Arrays& a) {
    o.edges = a.edges.data();
    o.cells = a.cells.data();
    o.lists = a.lists.data();
    o.edge_count = static_cast<std::int32_t>(a.edges.size() / 6);
    o.cell_count = static_cast<std::int32_t>(a.cells.size());
    o.list_count = static_cast<std::int32_t>(a.lists.size());
    return o;
  }

  const std::array<Arrays, 2> arrays_;
  ZoneTable table_;
  TimeUs stamp_us_ = never_us;
  HeldZone* next_ = nullptr;  // of those that were handed back
};

class ZoneSlot {
 public:
  ZoneSlot() = default;
  ZoneSlot(const ZoneSlot&) = delete;
  ZoneSlot& operator=(const ZoneSlot&) = delete;
  // When neither side is at work any more.
  ~ZoneSlot() {
    free_all(newest_.load());
    free_all(returned_.load());
    free_all(left_);
    free_all(current_);
  }

  // `stamp_us`: when it was received, of the clock of the monitors. One that nobody has taken yet
  // is freed.
  void publish(std::unique_ptr<HeldZone> zone, TimeUs stamp_us) {
    const std::lock_guard<std::mutex> one_at_a_time(publishing_);
    free_all(returned_.exchange(nullptr, std::memory_order_acquire));
    if (zone == nullptr) return;
    zone->stamp_us_ = stamp_us;
    free_all(newest_.exchange(zone.release(), std::memory_order_acq_rel));
  }

  // For one thread. Shows the newest zone, if there is one that was not shown before, to
  // `take(const ZoneTable&, TimeUs stamp_us)`, which tells whether it is taken: then it stays alive
  // until the next one is taken, else the one before does.
  template <class Take>
  bool offer(const Take& take) {
    static_assert(std::atomic<HeldZone*>::is_always_lock_free, "a reader never waits");
    HeldZone* const fresh = newest_.exchange(nullptr, std::memory_order_acq_rel);
    if (fresh == nullptr) {
      hand_back();
      return false;
    }
    const bool taken = take(std::as_const(fresh->table_), fresh->stamp_us_);
    HeldZone* const left = taken ? std::exchange(current_, fresh) : fresh;
    if (left != nullptr) {
      left->next_ = left_;
      left_ = left;
    }
    hand_back();
    return taken;
  }

 private:
  // Whoever publishes collects what is there; until then the rest waits here. Each zone that is
  // published leads to one that is left, so that there never are more than a few.
  void hand_back() {
    HeldZone* none = nullptr;
    if (left_ != nullptr &&
        returned_.compare_exchange_strong(none, left_, std::memory_order_release,
                                          std::memory_order_relaxed)) {
      left_ = nullptr;
    }
  }
  static void free_all(HeldZone* first) {
    while (first != nullptr) {
      const std::unique_ptr<HeldZone> zone(first);
      first = zone->next_;
    }
  }

  std::mutex publishing_;
  std::atomic<HeldZone*> newest_{nullptr}, returned_{nullptr};
  HeldZone *current_ = nullptr, *left_ = nullptr;  // of the thread that is offered zones
};

}  // namespace rtac
