#include <sas_core/sas_robot_driver.hpp>

#include <stdexcept>
#include <string>

namespace sas
{

RobotDriver::RobotDriver(const std::shared_ptr<ShutdownSignaler> & shutdown_signaler)
: shutdown_signaler_(shutdown_signaler ? shutdown_signaler : std::make_shared<ShutdownSignaler>()),
  break_loops_(shutdown_signaler_->flag())
{
}

RobotDriver::RobotDriver(std::atomic_bool * break_loops)
: RobotDriver(std::make_shared<ShutdownSignaler>(break_loops))
{
  break_loops_ = break_loops;
}

Eigen::VectorXd RobotDriver::get_joint_velocities()
{
  return {};
}

Eigen::VectorXd RobotDriver::get_joint_torques()
{
  return {};
}

void RobotDriver::set_target_joint_velocities(const Eigen::VectorXd &)
{
  throw std::runtime_error("sas::RobotDriver: this robot takes no target velocities.");
}

void RobotDriver::set_target_joint_torques(const Eigen::VectorXd &)
{
  throw std::runtime_error("sas::RobotDriver: this robot takes no target torques.");
}

std::tuple<Eigen::VectorXd, Eigen::VectorXd> RobotDriver::get_joint_limits()
{
  return joint_limits_;
}

void RobotDriver::set_joint_limits(const std::tuple<Eigen::VectorXd, Eigen::VectorXd> & joint_limits)
{
  const auto & [least, greatest] = joint_limits;
  if (least.size() != greatest.size()) {
    throw std::runtime_error(
      "sas::RobotDriver: there must be as many least joint limits as greatest ones; there are " +
      std::to_string(least.size()) + " and " + std::to_string(greatest.size()) + ".");
  }
  joint_limits_ = joint_limits;
}

}  // namespace sas
