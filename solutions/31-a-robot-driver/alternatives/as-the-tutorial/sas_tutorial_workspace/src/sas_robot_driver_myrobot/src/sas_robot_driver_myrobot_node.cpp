#include <signal.h>

#include <dqrobotics/utils/DQ_Math.h>

#include <rclcpp/rclcpp.hpp>
#include <sas_common/sas_common.hpp>
#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_robot_driver/sas_robot_driver_ros.hpp>

#include <sas_robot_driver_myrobot/sas_robot_driver_myrobot.hpp>

static std::atomic_bool stop(false);

static void on_ctrl_c(int)
{
  stop = true;
}

// The limits in this parameter, converted from degrees.
static VectorXd limits(const std::shared_ptr<rclcpp::Node> & node, const std::string & parameter)
{
  std::vector<double> degrees;
  sas::get_ros_parameter(node, parameter, degrees);
  return deg2rad(sas::std_vector_double_to_vectorxd(degrees));
}

int main(int argc, char ** argv)
{
  if (signal(SIGINT, on_ctrl_c) == SIG_ERR) {
    throw std::runtime_error("Ctrl+C would not end this program.");
  }
  rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
  auto node = std::make_shared<rclcpp::Node>("sas_robot_driver_myrobot");

  try {
    RCLCPP_INFO_STREAM_ONCE(node->get_logger(), "Reading the parameters");
    sas::RobotDriverMyrobotConfiguration robot;
    sas::get_ros_parameter(node, "ip", robot.ip);
    robot.joint_limits = {limits(node, "joint_limits_min"), limits(node, "joint_limits_max")};

    sas::RobotDriverROSConfiguration loop;
    sas::get_ros_parameter(node, "thread_sampling_time_sec", loop.thread_sampling_time_sec);
    loop.robot_driver_provider_prefix = node->get_name();

    RCLCPP_INFO_STREAM_ONCE(node->get_logger(), "Starting the driver");
    auto driver = std::make_shared<sas::RobotDriverMyrobot>(robot, &stop);
    sas::RobotDriverROS driver_ros(node, driver, loop, &stop);
    driver_ros.control_loop();
  } catch (const std::exception & problem) {
    RCLCPP_ERROR_STREAM_ONCE(node->get_logger(), std::string("It ended: ") + problem.what());
  }
  return 0;
}
