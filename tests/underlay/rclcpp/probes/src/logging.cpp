// Logs in all the ways that there are.

#include <functional>
#include <memory>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("logger");
  auto log = node->get_logger();
  RCLCPP_DEBUG(log, "debug %d", 1);
  RCLCPP_INFO(log, "info %s %.1f", "two", 2.0);
  RCLCPP_WARN_STREAM(log, "warn " << 3 << "!");
  RCLCPP_ERROR(rclcpp::get_logger("other"), "error 100%%");
  RCLCPP_FATAL(log.get_child("child"), "fatal");
  rclcpp::Clock clock(RCL_SYSTEM_TIME), simulated(RCL_ROS_TIME);
  if (rcl_enable_ros_time_override(simulated.get_clock_handle()) != RCL_RET_OK) {
    return 1;
  }
  const std::function<bool()> no = []() {return false;};
  const auto yes = []() {return true;};
  for (int i = 0; i < 3; ++i) {
    RCLCPP_INFO_ONCE(log, "once %d", i);
    RCLCPP_INFO_STREAM_ONCE(log, "stream once " << i);
    RCLCPP_INFO_SKIPFIRST(log, "skipfirst %d", i);
    RCLCPP_INFO_STREAM_SKIPFIRST(log, "stream skipfirst " << i);
    RCLCPP_INFO_EXPRESSION(log, i == 1, "expression %d", i);
    RCLCPP_INFO_STREAM_EXPRESSION(log, i == 1, "stream expression " << i);
    RCLCPP_INFO_FUNCTION(log, &no, "function %d", i);
    RCLCPP_INFO_STREAM_FUNCTION(log, &yes, "stream function " << i);
    RCLCPP_INFO_THROTTLE(log, clock, 1e9, "throttle %d", i);
    RCLCPP_INFO_STREAM_THROTTLE(log, *node->get_clock(), 1e9, "stream throttle " << i);
    RCLCPP_INFO_SKIPFIRST_THROTTLE(log, clock, 1e9, "skipfirst throttle %d", i);
    RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(log, clock, 1e9, "stream skipfirst throttle " << i);
    RCLCPP_INFO_THROTTLE(log, clock, 0, "unthrottled %d", i);
    if (rcl_set_ros_time_override(simulated.get_clock_handle(), RCL_S_TO_NS(i)) != RCL_RET_OK) {
      return 1;
    }
    RCLCPP_INFO_THROTTLE(log, simulated, 1000, "simulated %d", i);
    RCLCPP_INFO_SKIPFIRST_THROTTLE(log, simulated, 1000, "simulated skipfirst %d", i);
  }
  if (argc > 1 && argv[1] == std::string("stay")) {
    rclcpp::spin(node);  // /rosout is kept for those who come late
  }
  rclcpp::shutdown();
  RCLCPP_INFO(log, "after");
  return 0;
}
