#include <sas_robot_driver/sas_robot_driver_ros.hpp>

#include <exception>
#include <stdexcept>

namespace
{

template<typename Pointer>
Pointer present(Pointer pointer, const std::string & what)
{
  if (!pointer) {
    throw std::invalid_argument("sas::RobotDriverROS: " + what + " is a null pointer.");
  }
  return pointer;
}

}  // namespace

namespace sas
{

RobotDriverROS::RobotDriverROS(
  const std::shared_ptr<rclcpp::Node> & node, const std::shared_ptr<RobotDriver> & robot_driver,
  const RobotDriverROSConfiguration & configuration, std::atomic_bool * kill_this_node)
: RobotDriverROS(
    node, robot_driver, configuration,
    std::make_shared<ShutdownSignaler>(present(kill_this_node, "kill_this_node")))
{
}

RobotDriverROS::RobotDriverROS(
  const std::shared_ptr<rclcpp::Node> & node, const std::shared_ptr<RobotDriver> & robot_driver,
  const RobotDriverROSConfiguration & configuration,
  const std::shared_ptr<ShutdownSignaler> & shutdown_signaler)
: node_(present(node, "node")),
  robot_driver_(present(robot_driver, "robot_driver")),
  shutdown_signaler_(present(shutdown_signaler, "shutdown_signaler")),
  clock_(configuration.thread_sampling_time_sec),
  robot_driver_server_(node_, configuration.robot_driver_provider_prefix)
{
}

int RobotDriverROS::control_loop()
{
  bool well = carry_out("connect", [this] {robot_driver_->connect();});
  if (well && !should_shutdown()) {
    well = carry_out("initialize", [this] {robot_driver_->initialize();}) &&
      carry_out("control loop", [this] {loop();});
  }
  if (!well) {
    shutdown_signaler_->shutdown();
  }
  well = carry_out("deinitialize", [this] {robot_driver_->deinitialize();}) && well;
  well = carry_out("disconnect", [this] {robot_driver_->disconnect();}) && well;
  return well ? 0 : 1;
}

/// Whether the step went well; what it throws is logged.
bool RobotDriverROS::carry_out(const std::string & step, const std::function<void()> & action) const
{
  RCLCPP_INFO_STREAM(node_->get_logger(), "::Robot driver: " << step);
  try {
    action();
    return true;
  } catch (const std::exception & error) {
    RCLCPP_ERROR_STREAM(node_->get_logger(), "::Robot driver: " << step << " failed: " << error.what());
  } catch (...) {
    RCLCPP_ERROR_STREAM(
      node_->get_logger(),
      "::Robot driver: " << step << " failed: it threw something that is no std::exception.");
  }
  return false;
}

bool RobotDriverROS::should_shutdown() const
{
  return shutdown_signaler_->should_shutdown() || !rclcpp::ok();
}

void RobotDriverROS::loop()
{
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node_);
  clock_.init();
  while (!should_shutdown()) {
    clock_.update_and_sleep();
    tell();  // first of all, so that nothing delays it
    executor.spin_some();
    obey();
  }
}

void RobotDriverROS::tell()
{
  const Eigen::VectorXd joint_positions = robot_driver_->get_joint_positions();
  robot_driver_server_.send_joint_states(
    joint_positions, robot_driver_->get_joint_velocities(), robot_driver_->get_joint_torques());
  robot_driver_server_.send_joint_limits(robot_driver_->get_joint_limits());
  // Drivers have no way to tell of homing.
  robot_driver_server_.send_home_state(Eigen::VectorXi::Zero(joint_positions.size()));
}

void RobotDriverROS::obey()
{
  switch (robot_driver_server_.get_currently_active_functionality()) {
    case RobotDriver::Functionality::PositionControl:
      robot_driver_->set_target_joint_positions(robot_driver_server_.get_target_joint_positions());
      break;
    case RobotDriver::Functionality::VelocityControl:
      robot_driver_->set_target_joint_velocities(robot_driver_server_.get_target_joint_velocities());
      break;
    case RobotDriver::Functionality::ForceControl:
      robot_driver_->set_target_joint_torques(robot_driver_server_.get_target_joint_forces());
      break;
    case RobotDriver::Functionality::None:
    case RobotDriver::Functionality::Homing:
    case RobotDriver::Functionality::ClearPositions:
      break;
  }
}

}  // namespace sas
