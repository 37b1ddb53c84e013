#!/usr/bin/env bash
# misuse_test.sh RTAC ROOT CXX: mistakes of an application do not compile, and the message names
# what is wrong. Each source has a twin that differs in the mistake only and compiles.
set -euo pipefail

rtac=$1 root=$2 cxx=$3
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
failures=0

for spec in shared_recovery no_plan robot_delivery; do
  source=$root/tests/golden/$spec/spec.rta
  [[ -f $source ]] || source=$root/specs/$spec/$spec.rta
  "$rtac" build "$source" -o "$work/$spec"
done

compiles() { # SOURCE; messages go to $work/messages
  LC_ALL=C "$cxx" -std=c++17 -Wall -Wextra -Werror -fsyntax-only -I "$root/runtime/include" \
    -I "$work" "$1" >"$work/messages" 2>&1
}

# A line that ends in `//! TEXT` replaces the line before it in the faulty twin, whose messages must
# match TEXT.
twins() { # NAME; source on stdin
  local name=$1 pattern
  cat >"$work/$name.txt"
  pattern=$(sed -n 's|.*//! *||p' "$work/$name.txt")
  grep -v '//!' "$work/$name.txt" >"$work/$name.good.cpp"
  # keep the marked line instead of the one before it
  awk '/\/\/!/ { held = $0; have = 1; next } { if (have) print held; held = $0; have = 1 } END { print held }' \
    "$work/$name.txt" | sed 's| *//!.*||' >"$work/$name.bad.cpp"
  if ! compiles "$work/$name.good.cpp"; then
    printf '%s: the right source does not compile:\n' "$name"
    cat "$work/messages"
    failures=$((failures + 1))
  fi
  if compiles "$work/$name.bad.cpp"; then
    printf '%s: the mistake compiles\n' "$name"
    failures=$((failures + 1))
  elif ! grep -qE "$pattern" "$work/messages"; then
    printf '%s: no message matches %s:\n' "$name" "$pattern"
    head -20 "$work/messages"
    failures=$((failures + 1))
  fi
}

twins missing_controller <<'E2'
#include "shared_recovery/spec_system.h"
shared_recovery::DroneControllers fill(rtac::Controller<rtac::Acceleration>& pilot,
                                       rtac::SafeController<rtac::Acceleration>& land_now,
                                       rtac::Planner& planner) {
  return {pilot, land_now, planner};
  static_cast<void>(planner); return {pilot, land_now};  //! planner
}
E2

twins wrong_slot <<'E2'
#include "shared_recovery/spec_system.h"
shared_recovery::DroneControllers fill(rtac::Controller<rtac::Acceleration>& pilot,
                                       rtac::SafeController<rtac::Acceleration>& land_now,
                                       rtac::Planner& planner) {
  return {pilot, land_now, planner};
  return {land_now, land_now, planner};  static_cast<void>(pilot);  //! (SafeController|Controller)<
}
E2

twins missing_robot <<'E2'
#include "robot_delivery/robot_delivery_system.h"
using Slots = robot_delivery::TurtleBot3Controllers;
robot_delivery::System::Controllers fill(const Slots& r1, const Slots& r2, rtac::TaskSource& tasks) {
  return {r1, r2, tasks};
  static_cast<void>(r2); return {r1, tasks};  //! (TaskSource|TurtleBot3Controllers)
}
E2

twins speed_for_length <<'E2'
#include "no_plan/spec.h"
using namespace rtac::literals;
void feed(no_plan::Drive& drive) {
  drive.position({1.0_m, 2.0_m}, 0);
  drive.position({1.0_mps, 2.0_m}, 0);  //! (position|Position|Quantity|Length|Speed)
}
E2

twins velocity_for_position <<'E2'
#include "no_plan/spec.h"
using namespace rtac::literals;
void feed(no_plan::Drive& drive) {
  drive.velocity({1.0_mps, 0.0_mps}, 0);
  drive.position(rtac::Velocity{1.0_mps, 0.0_mps}, 0);  //! (position|Velocity|Position)
}
E2

twins bare_number <<'E2'
#include "no_plan/spec.h"
using namespace rtac::literals;
void feed(no_plan::Drive& drive) {
  drive.battery(82.0_pct, 0);
  drive.battery(0.82, 0);  //! (battery|Charge|double)
}
E2

twins decision_of_another_module <<'E2'
#include "no_plan/spec.h"
#include "robot_delivery/robot_delivery.h"
rtac::DecisionModule& use(no_plan::Drive& drive) {
  return drive;
  static robot_delivery::MotionPlanner planner; static_cast<void>(drive); return planner;  //! MotionPlanner
}
E2

((failures == 0))
