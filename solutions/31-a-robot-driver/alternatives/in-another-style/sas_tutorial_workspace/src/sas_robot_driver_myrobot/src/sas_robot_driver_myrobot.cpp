#include "sas_robot_driver_myrobot.hpp"

#include <algorithm>

#include <rclcpp/logging.hpp>

VectorXd sas::RobotDriverMyrobot::get_joint_positions()
{
  if (!connected_) {
    throw std::runtime_error("connect() first");
  }
  VectorXd positions(6);
  std::copy(positions_.begin(), positions_.end(), positions.data());
  return positions;
}

void sas::RobotDriverMyrobot::set_target_joint_positions(const VectorXd & target)
{
  if (target.size() != 6) {
    RCLCPP_WARN(rclcpp::get_logger("myrobot"), "%ld joints are too few or too many", long(target.size()));
    throw std::runtime_error("six joints are needed");
  }
  std::copy(target.data(), target.data() + 6, positions_.begin());
}
