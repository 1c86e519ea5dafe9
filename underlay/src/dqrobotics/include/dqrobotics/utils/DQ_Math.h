// Angles in degrees and in radians: numbers, and vectors of them.

#pragma once

#include <Eigen/Dense>

namespace DQ_robotics
{

double deg2rad(const double & degrees);
double rad2deg(const double & radians);

Eigen::VectorXd deg2rad(const Eigen::VectorXd & degrees);
Eigen::VectorXd rad2deg(const Eigen::VectorXd & radians);

}  // namespace DQ_robotics

// Programs of this family write `deg2rad(limits)` and `VectorXd` without a namespace.
using namespace DQ_robotics;  // NOLINT
using namespace Eigen;        // NOLINT
