#include <signal.h>

#include <exception>
#include <iostream>

#include <rclcpp/rclcpp.hpp>
#include <sas_common/sas_common.hpp>
#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_robot_driver/sas_robot_driver_ros.hpp>
#include <dqrobotics/utils/DQ_Math.h>

#include "sas_robot_driver_probe.hpp"

static std::atomic_bool kill_this_process(false);

void sig_int_handler(int)
{
  kill_this_process = true;
}

int main(int argc, char ** argv)
{
  if (signal(SIGINT, sig_int_handler) == SIG_ERR) {
    throw std::runtime_error("::Error setting the signal int handler.");
  }

  rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
  auto node = std::make_shared<rclcpp::Node>("sas_robot_driver_probe");

  try {
    sas::RobotDriverProbeConfiguration configuration;
    sas::get_ros_parameter(node, "ip", configuration.ip);
    std::vector<double> joint_limits_min;
    std::vector<double> joint_limits_max;
    sas::get_ros_parameter(node, "joint_limits_min", joint_limits_min);
    sas::get_ros_parameter(node, "joint_limits_max", joint_limits_max);
    configuration.joint_limits = {
      deg2rad(sas::std_vector_double_to_vectorxd(joint_limits_min)),
      deg2rad(sas::std_vector_double_to_vectorxd(joint_limits_max))};
    sas::get_ros_optional_parameter(node, "fail_in", configuration.fail_in, std::string());

    sas::RobotDriverROSConfiguration robot_driver_ros_configuration;
    sas::get_ros_parameter(
      node, "thread_sampling_time_sec", robot_driver_ros_configuration.thread_sampling_time_sec);
    robot_driver_ros_configuration.robot_driver_provider_prefix = node->get_name();

    auto robot_driver = std::make_shared<sas::RobotDriverProbe>(configuration, &kill_this_process);
    sas::RobotDriverROS robot_driver_ros(
      node, robot_driver, robot_driver_ros_configuration, &kill_this_process);
    const int returned = robot_driver_ros.control_loop();
    std::cout << "returned " << returned << std::endl;
  } catch (const std::exception & e) {
    RCLCPP_ERROR_STREAM_ONCE(node->get_logger(), std::string("::Exception::") + e.what());
  }
  sas::display_signal_handler_none_bug_info(node);
  return 0;
}
