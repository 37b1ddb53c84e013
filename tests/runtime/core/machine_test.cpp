// Machines, their bounded queues, and the watchdog: the frame every layer of the stack runs in.
#include "rtac/machine.h"

#include <gtest/gtest.h>

#include <vector>

#include "rtac/watchdog.h"

namespace rtac {
namespace {

// Events come out in the order in which they went in, also after the ring wrapped.
TEST(EventQueue, KeepsOrderAroundTheRing) {
  EventQueue<int, 3> queue;
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(queue.push(2 * i), Status::ok);
    ASSERT_EQ(queue.push(2 * i + 1), Status::ok);
    EXPECT_EQ(queue.front(), 2 * i);
    queue.pop();
    EXPECT_EQ(queue.front(), 2 * i + 1);
    queue.pop();
  }
  EXPECT_TRUE(queue.empty());
}

// A full queue refuses instead of overwriting what waits.
TEST(EventQueue, RefusesWhenFull) {
  EventQueue<int, 2> queue;
  ASSERT_EQ(queue.push(1), Status::ok);
  ASSERT_EQ(queue.push(2), Status::ok);
  EXPECT_EQ(queue.push(3), Status::full);
  EXPECT_EQ(queue.front(), 1);
}

class Relay : public Machine<int, 4> {
 public:
  Relay(int name, std::vector<int>& trace) : name_(name), trace_(trace) {}
  Relay* next = nullptr;

 private:
  void handle(const int& hops) override {
    trace_.push_back(name_);
    if (hops > 0) next->post(hops - 1);
  }
  int name_;
  std::vector<int>& trace_;
};

// The executive goes on until no machine has work, in the order in which they were added.
TEST(Executive, RunsUntilQuiescentInOrder) {
  std::vector<int> trace;
  Relay a(1, trace), b(2, trace);
  a.next = &b, b.next = &a;
  Executive executive;
  ASSERT_EQ(executive.add(a), Status::ok);
  ASSERT_EQ(executive.add(b), Status::ok);
  b.post(0);
  a.post(3);
  EXPECT_EQ(executive.run_until_quiescent(), Status::ok);
  EXPECT_EQ(trace, (std::vector<int>{1, 2, 2, 1, 2}));
}

// Machines that keep each other busy for ever are reported, not followed for ever.
TEST(Executive, BoundsTheRounds) {
  std::vector<int> trace;
  Relay a(1, trace);
  a.next = &a;
  Executive executive;
  ASSERT_EQ(executive.add(a), Status::ok);
  a.post(1 << 30);
  EXPECT_EQ(executive.run_until_quiescent(100), Status::full);
  EXPECT_EQ(trace.size(), 100u);
}

// An event that finds no room is counted, so that the system can report the overload.
TEST(Machine, CountsDroppedEvents) {
  std::vector<int> trace;
  Relay a(1, trace);
  for (int i = 0; i < 6; ++i) a.post(0);
  EXPECT_EQ(a.dropped(), 2u);
}

// The watchdog expires only after more than its periods, or when the clock goes backwards.
TEST(Watchdog, ExpiresWhenLate) {
  Watchdog watchdog(100'000, 3);
  EXPECT_FALSE(watchdog.expired(10'000'000));
  watchdog.stepped(1'000'000);
  EXPECT_FALSE(watchdog.expired(1'300'000));
  EXPECT_TRUE(watchdog.expired(1'300'001));
  EXPECT_TRUE(watchdog.expired(999'999));
}

}  // namespace
}  // namespace rtac
