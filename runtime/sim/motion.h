// Private: the dynamics of one robot. See rtac/sim/world.h for the integration scheme.
#pragma once

#include <Eigen/Core>

#include "rtac/types.h"

namespace rtac::sim {

struct Body {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m, map frame; z: robots in space alone
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, map frame
  double heading_rad = 0;
  double speed_mps = 0;  // along the heading, signed; point mass: norm of the velocity
  double turn_radps = 0;
};

// The command that the actuators accept: all zero unless every component is finite.
Acceleration accepted(const Acceleration& command);
Twist accepted(const Twist& command);

// Moves `body` by `dt_s` under `command` and returns the metres driven.
double advance(Body& body, const Acceleration& command, const RobotLimits& limits, double dt_s);
double advance(Body& body, const Twist& command, const RobotLimits& limits, double dt_s);

}  // namespace rtac::sim
