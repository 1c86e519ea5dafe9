#pragma once

#include "rclcpp/macros.hpp"
#include "rclcpp/time_source.hpp"

namespace rclcpp::node_interfaces
{

/// Lets the clock of a node follow /clock while its parameter use_sim_time is true.
class NodeTimeSourceInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTimeSourceInterface)

  NodeTimeSourceInterface(
    const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & parameters,
    const Clock::SharedPtr & clock, const QoS & qos, bool use_clock_thread);

private:
  TimeSource time_source_;
};

}  // namespace rclcpp::node_interfaces
