#pragma once

#include <utility>

#include "rclcpp/logger.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp::node_interfaces
{

/// The logger of a node.
class NodeLoggingInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeLoggingInterface)

  explicit NodeLoggingInterface(NodeBaseInterface::SharedPtr node) : node_(std::move(node)) {}

  Logger get_logger() const {return get_node_logger(node_->get_rcl_node_handle());}
  const char * get_logger_name() const {return rcl_node_get_logger_name(node_->get_rcl_node_handle());}

private:
  NodeBaseInterface::SharedPtr node_;
};

}  // namespace rclcpp::node_interfaces
