#include <signal.h>

#include <exception>

#include <dqrobotics/utils/DQ_Math.h>
#include <rclcpp/rclcpp.hpp>
#include <sas_common/sas_common.hpp>
#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_robot_driver/sas_robot_driver_ros.hpp>

#include "sas_robot_driver_myrobot.hpp"

using namespace sas;

static std::atomic_bool ended(false);

void end(int)
{
    ended = true;
}

int main(int argc, char** argv)
{
    signal(SIGINT, end);
    rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
    auto node = std::make_shared<rclcpp::Node>("sas_robot_driver_myrobot");

    try
    {
        std::vector<double> lowest, highest;
        get_ros_parameter(node, "joint_limits_min", lowest);
        get_ros_parameter(node, "joint_limits_max", highest);
        RobotDriverMyrobotConfiguration configuration;
        get_ros_parameter(node, "ip", configuration.ip);
        configuration.joint_limits = std::make_tuple(
            deg2rad(std_vector_double_to_vectorxd(lowest)), deg2rad(std_vector_double_to_vectorxd(highest)));

        RobotDriverROSConfiguration ros;
        get_ros_parameter(node, "thread_sampling_time_sec", ros.thread_sampling_time_sec);
        ros.robot_driver_provider_prefix = node->get_name();

        std::shared_ptr<RobotDriver> robot = std::make_shared<RobotDriverMyrobot>(configuration, &ended);
        RobotDriverROS runs(node, robot, ros, &ended);
        runs.control_loop();
    }
    catch (const std::exception& e)
    {
        RCLCPP_ERROR_STREAM(node->get_logger(), "The driver ends: " << e.what());
    }
    return 0;
}
