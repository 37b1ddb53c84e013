// What every safe-controller template is told at construction.
#pragma once

#include <limits>

#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac::safe {

struct Setting {
  RobotLimits limits;
  TimeUs period_us = 0;  // of the decision: a command is issued every period
  double speed_mps = 0;  // of the recovery, once the robot has come to rest
  const ZoneView* zone = nullptr;
  // Clearance of the CENTRE that a moving recovery keeps: body and tube.
  double route_clearance_m = 0;
  // Clearance of the CENTRE at which control can be given back (theory: rho_ret + r_eff), plus a
  // little.
  double return_clearance_m = 0;
  // Distance between CENTRES at which another robot can pass a held one.
  double pass_gap_m = 0;
  // How much longer than the direct way to its site a recovery may drive in all: what the reserve
  // of the energy monitor covers. Beyond it, it waits for the others to make room.
  double detour_m = std::numeric_limits<double>::infinity();
  const SolidView* solid = nullptr;  // of a robot in space, instead of the zone
  double land_at_m = 0;              // of a landing: how high the centre ends
};

}  // namespace rtac::safe
