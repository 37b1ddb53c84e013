// Admissible motions of a point mass, whatever proposed them.
#pragma once

#include <random>

#include "reach_nlp.h"

namespace rtac::optimize {

// Every value is finite and in its range, and some true state fits the measurement.
bool valid(const ReachProblem& problem);

// The closest point of the ball.
Vec2 clip(Vec2 p, Vec2 centre, double radius);

// The admissible trajectory next to a candidate, which may exceed limits a little. Projecting onto
// the cap keeps the limit on the acceleration: the projection onto a convex set that contains the
// old velocity does not lengthen the step.
void simulate(const ReachProblem& problem, const Candidate& candidate, WorstCase& result);

// The worst moment for the brake to act, exactly.
void judge(const ReachProblem& problem, WorstCase& result);

// From [0, 1), and a unit vector: unlike the distributions of the library, the same everywhere.
double draw_share(std::mt19937_64& random);
Vec2 draw_direction(std::mt19937_64& random);

}  // namespace rtac::optimize
