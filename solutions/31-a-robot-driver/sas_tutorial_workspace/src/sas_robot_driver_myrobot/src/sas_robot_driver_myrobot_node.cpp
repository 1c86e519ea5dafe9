#include <atomic>
#include <csignal>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <dqrobotics/utils/DQ_Math.h>

#include <rclcpp/rclcpp.hpp>
#include <sas_common/sas_common.hpp>
#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_robot_driver/sas_robot_driver_ros.hpp>

#include "sas_robot_driver_myrobot.hpp"

static std::atomic_bool kill_this_process(false);

void sig_int_handler(int)
{
  kill_this_process = true;
}

sas::RobotDriverMyrobotConfiguration driver_configuration(const std::shared_ptr<rclcpp::Node> & node)
{
  sas::RobotDriverMyrobotConfiguration configuration;
  std::vector<double> joint_limits_min;
  std::vector<double> joint_limits_max;
  sas::get_ros_parameter(node, "ip", configuration.ip);
  sas::get_ros_parameter(node, "joint_limits_min", joint_limits_min);
  sas::get_ros_parameter(node, "joint_limits_max", joint_limits_max);
  configuration.joint_limits = {
    DQ_robotics::deg2rad(sas::std_vector_double_to_vectorxd(joint_limits_min)),
    DQ_robotics::deg2rad(sas::std_vector_double_to_vectorxd(joint_limits_max))};
  return configuration;
}

sas::RobotDriverROSConfiguration loop_configuration(const std::shared_ptr<rclcpp::Node> & node)
{
  sas::RobotDriverROSConfiguration configuration;
  sas::get_ros_parameter(node, "thread_sampling_time_sec", configuration.thread_sampling_time_sec);
  configuration.robot_driver_provider_prefix = node->get_name();
  return configuration;
}

int main(int argc, char ** argv)
{
  if (std::signal(SIGINT, sig_int_handler) == SIG_ERR) {
    throw std::runtime_error("The handler for SIGINT could not be set.");
  }

  // No handlers from rclcpp: Ctrl+C must only end the loop, so that the robot shuts down in order.
  rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
  auto node = std::make_shared<rclcpp::Node>("sas_robot_driver_myrobot");

  try {
    auto driver = std::make_shared<sas::RobotDriverMyrobot>(
      driver_configuration(node), &kill_this_process);
    sas::RobotDriverROS driver_ros(node, driver, loop_configuration(node), &kill_this_process);
    return driver_ros.control_loop();
  } catch (const std::exception & error) {
    RCLCPP_ERROR_STREAM(node->get_logger(), "::Exception::" << error.what());
    return 1;
  }
}
