#pragma once

#include <string>
#include <tuple>

#include <Eigen/Dense>

namespace sas
{

struct RobotDriverMyrobotConfiguration
{
  std::string ip;
  std::tuple<Eigen::VectorXd, Eigen::VectorXd> joint_limits;
};

}  // namespace sas
