#pragma once

#include <utility>

#include "rclcpp/timer.hpp"

namespace rclcpp::node_interfaces
{

/// Adds timers to a node.
class NodeTimersInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTimersInterface)

  explicit NodeTimersInterface(NodeBaseInterface::SharedPtr node) : node_(std::move(node)) {}

  /// To `callback_group`, or to the default one of the node.
  void add_timer(TimerBase::SharedPtr timer, CallbackGroup::SharedPtr callback_group)
  {
    node_->add(timer, callback_group);
  }

private:
  NodeBaseInterface::SharedPtr node_;
};

}  // namespace rclcpp::node_interfaces
