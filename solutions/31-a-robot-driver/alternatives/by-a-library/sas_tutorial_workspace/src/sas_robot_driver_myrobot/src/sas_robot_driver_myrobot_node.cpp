#include <signal.h>

#include <exception>

#include <dqrobotics/utils/DQ_Math.h>
#include <rclcpp/rclcpp.hpp>
#include <sas_common/sas_common.hpp>
#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_robot_driver/sas_robot_driver_ros.hpp>

#include "sas_robot_driver_myrobot.hpp"

using namespace sas;

static std::atomic_bool kill_this_process(false);

void sig_int_handler(int)
{
    kill_this_process = true;
}

int main(int argc, char** argv)
{
    if (signal(SIGINT, sig_int_handler) == SIG_ERR)
    {
        throw std::runtime_error("Error setting the signal int handler.");
    }

    rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
    auto node = std::make_shared<rclcpp::Node>("sas_robot_driver_myrobot");

    try
    {
        RCLCPP_INFO_STREAM_ONCE(node->get_logger(), "::Loading parameters.");

        RobotDriverMyrobotConfiguration configuration;
        get_ros_parameter(node, "ip", configuration.ip);
        std::vector<double> joint_limits_min;
        std::vector<double> joint_limits_max;
        get_ros_parameter(node, "joint_limits_min", joint_limits_min);
        get_ros_parameter(node, "joint_limits_max", joint_limits_max);
        configuration.joint_limits = {deg2rad(std_vector_double_to_vectorxd(joint_limits_min)),
                                      deg2rad(std_vector_double_to_vectorxd(joint_limits_max))};

        RobotDriverROSConfiguration robot_driver_ros_configuration;
        get_ros_parameter(node, "thread_sampling_time_sec", robot_driver_ros_configuration.thread_sampling_time_sec);
        robot_driver_ros_configuration.robot_driver_provider_prefix = node->get_name();

        std::shared_ptr<RobotDriver> robot_driver = std::make_shared<RobotDriverMyrobot>(configuration, &kill_this_process);

        RobotDriverROS robot_driver_ros(node, robot_driver, robot_driver_ros_configuration, &kill_this_process);
        robot_driver_ros.control_loop();
    }
    catch (const std::exception& e)
    {
        RCLCPP_ERROR_STREAM_ONCE(node->get_logger(), std::string("::Exception::") + e.what());
    }
    return 0;
}
