#pragma once

#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp::node_interfaces
{

/// For functions that take one, as rclcpp_action's: actions consist of services and topics of the node.
class NodeWaitablesInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeWaitablesInterface)

  explicit NodeWaitablesInterface(NodeBaseInterface::SharedPtr node) : node_(std::move(node)) {}
  NodeBaseInterface::SharedPtr get_node_base_interface() const {return node_;}

private:
  NodeBaseInterface::SharedPtr node_;
};

}  // namespace rclcpp::node_interfaces
