#include "sas_robot_driver_myrobot.hpp"

#include <iostream>
#include <stdexcept>

#include "joints.hpp"

namespace sas
{

RobotDriverMyrobot::RobotDriverMyrobot(
  const RobotDriverMyrobotConfiguration & configuration, std::atomic_bool * break_loops)
: RobotDriver(break_loops)
{
  joint_limits_ = configuration.joint_limits;
}

RobotDriverMyrobot::~RobotDriverMyrobot() = default;

VectorXd RobotDriverMyrobot::get_joint_positions()
{
  if (!joints_) {
    throw std::runtime_error("There is no connection.");
  }
  return joints_->positions();
}

void RobotDriverMyrobot::set_target_joint_positions(const VectorXd & target)
{
  if (!joints_) {
    throw std::runtime_error("There is no connection.");
  }
  joints_->move(target);
}

void RobotDriverMyrobot::connect()
{
  joints_ = std::make_unique<Joints>();
}

void RobotDriverMyrobot::disconnect()
{
  joints_.reset();
  std::cout << "Disconnected." << std::endl;
}

void RobotDriverMyrobot::initialize()
{
  std::cout << "Motor on." << std::endl;
}

void RobotDriverMyrobot::deinitialize()
{
  std::cout << "Motor off." << std::endl;
}

}  // namespace sas
