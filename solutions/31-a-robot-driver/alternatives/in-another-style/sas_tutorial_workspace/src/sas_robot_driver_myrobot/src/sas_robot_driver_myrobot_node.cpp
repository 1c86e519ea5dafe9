#include <signal.h>

#include <cmath>
#include <exception>
#include <memory>
#include <vector>

#include <rclcpp/rclcpp.hpp>
#include <sas_common/sas_common.hpp>
#include <sas_robot_driver/sas_robot_driver_ros.hpp>

#include "sas_robot_driver_myrobot.hpp"

std::atomic_bool stop{false};

VectorXd radians(const std::vector<double> & degrees)
{
  return Eigen::Map<const VectorXd>(degrees.data(), degrees.size()) * M_PI / 180.0;
}

int main(int argc, char ** argv)
{
  struct sigaction action = {};
  action.sa_handler = [](int) {stop = true;};
  sigaction(SIGINT, &action, nullptr);

  rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
  const auto node = rclcpp::Node::make_shared("a_robot");
  int code = 1;
  try {
    sas::RobotDriverMyrobotConfiguration configuration;
    std::vector<double> least;
    std::vector<double> greatest;
    sas::RobotDriverROSConfiguration loop;
    sas::get_ros_parameter(node, "thread_sampling_time_sec", loop.thread_sampling_time_sec);
    sas::get_ros_parameter(node, "joint_limits_max", greatest);
    sas::get_ros_parameter(node, "joint_limits_min", least);
    sas::get_ros_parameter(node, "ip", configuration.ip);
    configuration.joint_limits = std::make_tuple(radians(least), radians(greatest));
    loop.robot_driver_provider_prefix = std::string("/") + node->get_name();

    sas::RobotDriverROS driver(
      node, std::make_shared<sas::RobotDriverMyrobot>(configuration, &stop), loop, &stop);
    code = driver.control_loop();
  } catch (const std::exception & error) {
    RCLCPP_FATAL(node->get_logger(), "%s", error.what());
  }
  rclcpp::shutdown();
  return code;
}
