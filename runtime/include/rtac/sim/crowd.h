// Agents: bodies that move by themselves up to a speed, against the robots, and what robots see of
// them, as misleading and as old as is declared.
#pragma once

#include <string>
#include <vector>

#include "rtac/sim/hostile.h"
#include "rtac/sim/property.h"
#include "rtac/sim/random.h"
#include "rtac/sim/tape.h"

namespace rtac::sim {

struct AgentSetup {
  std::string name;
  double radius_m = 0, speed_mps = 0, error_m = 0;
  TimeUs age_us = 0;
  bool in_space = false;  // else it keeps its height, 0
};

class Crowd {
 public:
  // Where it starts and how it moves depends on the seed and on the robots alone. `truths` are
  // those of the running world; all of it outlives the crowd. `surroundings` gets the agents.
  Crowd(const std::vector<AgentSetup>& agents, const std::vector<Property>& properties,
        Surroundings& surroundings, const std::vector<TruthState>& truths,
        const Hostility& hostility, std::uint64_t seed, Tape& tape);
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  // At time 0 and after every step of the world, in order.
  void move(TimeUs now_us);
  // The newest sample that the robot has of the agent.
  Sample<Vec3> see(int robot, int agent, TimeUs now_us);

 private:
  enum class Phase { charge, wander, away, stand };
  struct Mind {
    Phase phase = Phase::charge;
    TimeUs until_us = 0;
    Vec3 direction{1, 0, 0};
    Vec3 seen_off;  // where a lasting error of 1 m points to
  };
  struct Moment {
    TimeUs time_us = 0;
    std::vector<Vec3> places;
  };
  void place(const std::vector<Property>& properties, const Surroundings& surroundings);
  void decide(std::size_t agent, TimeUs now_us);
  // The way there, level for an agent that keeps its height.
  [[nodiscard]] Vec3 way_to_nearest(std::size_t agent) const;
  [[nodiscard]] const Moment& at(TimeUs time_us) const;
  [[nodiscard]] Vec3 offset(std::size_t agent, Vec3 away);
  // On a circle, in space on a sphere.
  [[nodiscard]] Vec3 any_way(Random& random, std::size_t agent, double size) const;
  [[nodiscard]] Vec3 level(std::size_t agent, Vec3 way) const;

  const std::vector<AgentSetup>& agents_;
  const std::vector<TruthState>& truths_;
  Hostility hostility_;
  Tape& tape_;
  Random moves_, noise_;
  std::vector<Vec3> places_;
  std::vector<Mind> minds_;
  std::vector<Moment> log_;
  TimeUs longest_us_ = 0, now_us_ = never_us;
  std::vector<std::vector<Sample<Vec3>>> seen_;  // by robot, then agent
};

}  // namespace rtac::sim
