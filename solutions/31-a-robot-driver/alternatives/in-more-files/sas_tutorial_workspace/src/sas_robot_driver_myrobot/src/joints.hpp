#pragma once

#include <Eigen/Dense>

/// The six joints of a connected robot.
class Joints
{
public:
  const Eigen::VectorXd & positions() const;
  void move(const Eigen::VectorXd & target);

private:
  Eigen::VectorXd positions_ = Eigen::VectorXd::Zero(6);
};
