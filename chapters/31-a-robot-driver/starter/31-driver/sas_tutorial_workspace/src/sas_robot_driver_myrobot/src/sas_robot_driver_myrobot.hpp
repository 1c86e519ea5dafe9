#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <tuple>

#include <sas_core/sas_robot_driver.hpp>

namespace sas
{

struct RobotDriverMyrobotConfiguration
{
  std::string ip;
  std::tuple<VectorXd, VectorXd> joint_limits;  // lowest and highest, in rad
};

// TODO: write the class RobotDriverMyrobot. Its constructor takes a configuration and a std::atomic_bool *, in this order.

}  // namespace sas
