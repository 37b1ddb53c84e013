// Commands of an attack on the tape, or from there.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "rtac/controller.h"
#include "rtac/sim/tape.h"

namespace rtac::simulate {

template <class Output>
class Taped final : public Controller<Output> {
 public:
  // `word`: what its lines begin with.
  Taped(std::unique_ptr<Controller<Output>> attack, const char* word, int robot, sim::Tape& tape)
      : attack_(std::move(attack)), word_(word), robot_(robot), tape_(tape) {}
  Output command(const Observation& observation) override {
    Output output = attack_->command(observation);
    std::vector<std::int64_t> whole{robot_};
    std::vector<double> real = numbers(output);
    if (tape_.playing() && tape_.read(word_, whole, real, 1)) give(real, output);
    tape_.write(word_, whole, real);
    return output;
  }

 private:
  static std::vector<double> numbers(const Acceleration& a) {
    return {a.value_mps2.x, a.value_mps2.y, a.up_mps2};
  }
  static std::vector<double> numbers(const Twist& t) { return {t.speed_mps, t.turn_radps}; }
  static void give(const std::vector<double>& from, Acceleration& to) {
    to = {{from[0], from[1]}, from[2]};
  }
  static void give(const std::vector<double>& from, Twist& to) { to = {from[0], from[1]}; }

  std::unique_ptr<Controller<Output>> attack_;
  const char* word_;
  int robot_;
  sim::Tape& tape_;
};

}  // namespace rtac::simulate
