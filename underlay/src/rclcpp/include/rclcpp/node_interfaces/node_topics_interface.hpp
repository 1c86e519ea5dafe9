#pragma once

#include <string>
#include <utility>

#include "rclcpp/node_interfaces/node_timers_interface.hpp"

namespace rclcpp::node_interfaces
{

/// What the names of topics become for a node. rclcpp::create_publisher takes it, too.
class NodeTopicsInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTopicsInterface)

  NodeTopicsInterface(NodeBaseInterface::SharedPtr node, NodeTimersInterface::SharedPtr timers)
  : node_(std::move(node)), timers_(std::move(timers)) {}

  std::string resolve_topic_name(const std::string & name, bool only_expand = false) const
  {
    return node_->resolve_topic_or_service_name(name, false, only_expand);
  }
  NodeBaseInterface::SharedPtr get_node_base_interface() const {return node_;}
  NodeTimersInterface::SharedPtr get_node_timers_interface() const {return timers_;}

private:
  NodeBaseInterface::SharedPtr node_;
  NodeTimersInterface::SharedPtr timers_;
};

}  // namespace rclcpp::node_interfaces
