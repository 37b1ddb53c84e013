// Private: announcements between the robots of a fleet, each delayed as its receiver declares.
#pragma once

#include <vector>

#include "sensor.h"

namespace rtac::sim {

class Radio {
 public:
  Radio(const std::vector<RobotSetup>& robots, std::uint64_t seed);
  // False: too many are under way, this one is lost.
  bool send(int from, const Announcement& announcement, TimeUs now_us);
  void receive(int to, TimeUs now_us, Observation& observation);
  void inject(const Fault& fault);

 private:
  struct Message {
    Announcement content;
    TimeUs sent_us = never_us;
  };
  // Oldest first. A message leaves when a newer one has reached everybody.
  struct Channel {
    std::vector<Message> ring;
    std::size_t first = 0, size = 0;
    [[nodiscard]] const Message& at(std::size_t i) const { return ring[(first + i) % ring.size()]; }
  };
  struct Ear {
    TimeUs delay_us = 0;
    FaultList<Vec2> faults;
    std::vector<Announcement> heard;  // by sender
    std::vector<TimeUs> sent_us;      // of `heard`
    std::vector<Vec2> position_before_fault, velocity_before_fault;
  };
  void hear(Ear& ear, std::size_t from, const Message& message);

  TimeUs longest_delay_us_ = 0;
  std::vector<Channel> channels_;  // by sender
  std::vector<Ear> ears_;          // by receiver
  Random random_;
};

}  // namespace rtac::sim
