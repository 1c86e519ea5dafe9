#pragma once

#include "rclcpp/node_interfaces/node_topics_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeTopics = NodeTopicsInterface;

}  // namespace rclcpp::node_interfaces
