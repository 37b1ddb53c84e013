#include "radio.h"

#include <algorithm>

namespace rtac::sim {
namespace {
constexpr std::size_t channel_capacity = 128;
constexpr std::uint64_t radio_stream = 1001;
}  // namespace

Radio::Radio(const std::vector<RobotSetup>& robots, std::uint64_t seed)
    : random_(Random::stream(seed, radio_stream, 0)) {
  const std::size_t count = robots.size();
  if (count < 2) return;  // nobody listens
  channels_.resize(count);
  for (Channel& channel : channels_) channel.ring.resize(channel_capacity);
  ears_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    ears_[i].delay_us = delivery_delay_us(robots[i].limits.hears_age_us);
    ears_[i].heard.resize(count);
    ears_[i].sent_us.assign(count, never_us);
    ears_[i].position_before_fault.resize(count);
    ears_[i].velocity_before_fault.resize(count);
    longest_delay_us_ = std::max(longest_delay_us_, ears_[i].delay_us);
  }
}

bool Radio::send(int from, const Announcement& announcement, TimeUs now_us) {
  if (channels_.empty()) return true;
  Channel& channel = channels_[static_cast<std::size_t>(from)];
  while (channel.size >= 2 && channel.at(1).sent_us + longest_delay_us_ <= now_us) {
    // Whoever has not looked yet will see the newer one.
    channel.first = (channel.first + 1) % channel.ring.size();
    --channel.size;
  }
  if (channel.size == channel.ring.size()) return false;
  channel.ring[(channel.first + channel.size) % channel.ring.size()] = {announcement, now_us};
  ++channel.size;
  return true;
}

void Radio::hear(Ear& ear, std::size_t from, const Message& message) {
  Announcement& heard = ear.heard[from];
  heard = message.content;
  ear.sent_us[from] = message.sent_us;
  if (ear.faults.active(message.sent_us)) {
    heard.position.value =
        ear.faults.applied(heard.position.value, ear.position_before_fault[from], message.sent_us);
    heard.velocity.value = ear.faults.applied(heard.velocity.value, ear.velocity_before_fault[from],
                                              message.sent_us, false);
  } else {
    ear.position_before_fault[from] = heard.position.value;
    ear.velocity_before_fault[from] = heard.velocity.value;
  }
}

void Radio::receive(int to, TimeUs now_us, Observation& observation) {
  if (ears_.empty()) return;
  Ear& ear = ears_[static_cast<std::size_t>(to)];
  for (std::size_t from = 0; from < channels_.size(); ++from) {
    if (from == static_cast<std::size_t>(to)) continue;
    const Channel& channel = channels_[from];
    for (std::size_t i = channel.size; i-- > 0;) {
      const Message& message = channel.at(i);
      if (message.sent_us <= ear.sent_us[from]) break;  // known, and so are all older ones
      if (message.sent_us + ear.delay_us > now_us || ear.faults.drops(message.sent_us)) continue;
      hear(ear, from, message);
      break;
    }
    observation.others[from] = ear.heard[from];
  }
}

void Radio::inject(const Fault& fault) {
  if (ears_.empty()) return;
  ears_[static_cast<std::size_t>(fault.robot)].faults.add(fault, random_);
}

}  // namespace rtac::sim
