#include "sas_robot_driver_myrobot.hpp"

#include <iostream>
#include <stdexcept>
#include <string>

namespace
{

constexpr int joints = 6;

void tell(const std::string & what)
{
  std::cerr << "[RobotDriverMyrobot] " << what << std::endl;
}

}  // namespace

namespace sas
{

/// The hidden part of the driver. For a real robot, it would use the manufacturer's library.
class RobotDriverMyrobot::Impl
{
public:
  void connect(const std::string & ip)
  {
    tell("Connected to " + ip + ".");
    joint_positions_ = Eigen::VectorXd::Zero(joints);
  }

  void disconnect()
  {
    joint_positions_.resize(0);
    tell("Disconnected.");
  }

  void set_motor(bool on)
  {
    tell(on ? "Motor on." : "Motor off.");
  }

  const Eigen::VectorXd & joint_positions() const
  {
    if (joint_positions_.size() == 0) {
      throw std::runtime_error("The robot is not connected: it has no joint positions.");
    }
    return joint_positions_;
  }

  void move(const Eigen::VectorXd & target)
  {
    if (target.size() != joints) {
      throw std::runtime_error(
        "A target needs " + std::to_string(joints) + " joint positions; this one has " +
        std::to_string(target.size()) + ".");
    }
    joint_positions_ = target;
  }

private:
  Eigen::VectorXd joint_positions_;  // empty while there is no connection
};

RobotDriverMyrobot::RobotDriverMyrobot(
  const RobotDriverMyrobotConfiguration & configuration, std::atomic_bool * break_loops)
: RobotDriver(break_loops), impl_(std::make_unique<Impl>()), configuration_(configuration)
{
  joint_limits_ = configuration.joint_limits;
}

RobotDriverMyrobot::~RobotDriverMyrobot() = default;  // here, because Impl is defined above

Eigen::VectorXd RobotDriverMyrobot::get_joint_positions()
{
  return impl_->joint_positions();
}

void RobotDriverMyrobot::set_target_joint_positions(const Eigen::VectorXd & target_joint_positions_rad)
{
  impl_->move(target_joint_positions_rad);
}

void RobotDriverMyrobot::connect()
{
  impl_->connect(configuration_.ip);
}

void RobotDriverMyrobot::disconnect()
{
  impl_->disconnect();
}

void RobotDriverMyrobot::initialize()
{
  impl_->set_motor(true);
}

void RobotDriverMyrobot::deinitialize()
{
  impl_->set_motor(false);
}

}  // namespace sas
