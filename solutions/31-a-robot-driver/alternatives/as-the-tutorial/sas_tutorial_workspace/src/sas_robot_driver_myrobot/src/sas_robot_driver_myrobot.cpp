#include "sas_robot_driver_myrobot/sas_robot_driver_myrobot.hpp"

#include <stdexcept>

namespace sas
{

class RobotDriverMyrobot::Impl
{
public:
  bool is_open = false;
  bool has_power = false;
  VectorXd radians;  // empty while there is no connection
};

RobotDriverMyrobot::RobotDriverMyrobot(
  const RobotDriverMyrobotConfiguration & settings, std::atomic_bool * stop)
: RobotDriver(stop), settings_(settings), impl_(std::make_unique<Impl>())
{
  joint_limits_ = settings_.joint_limits;
}

RobotDriverMyrobot::~RobotDriverMyrobot() {}

void RobotDriverMyrobot::connect()
{
  if (impl_->is_open) {
    throw std::runtime_error("A robot has only one connection.");
  }
  impl_->is_open = true;
  impl_->has_power = false;
  impl_->radians = VectorXd::Zero(6);
}

void RobotDriverMyrobot::initialize()
{
  impl_->has_power = true;
}

VectorXd RobotDriverMyrobot::get_joint_positions()
{
  if (impl_->radians.size() > 0) {
    return impl_->radians;
  }
  throw std::runtime_error("Without a connection, nobody knows where the joints are.");
}

void RobotDriverMyrobot::set_target_joint_positions(const VectorXd & radians)
{
  if (radians.size() != 6) {
    throw std::runtime_error("A target needs six elements.");
  }
  impl_->radians = radians;
}

void RobotDriverMyrobot::deinitialize()
{
  impl_->has_power = false;
}

void RobotDriverMyrobot::disconnect()
{
  impl_->is_open = false;
  impl_->radians = VectorXd();
}

}
