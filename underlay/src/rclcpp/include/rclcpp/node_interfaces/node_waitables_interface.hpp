#pragma once

#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp::node_interfaces
{

/// Adds waitables to a node. Functions as rclcpp_action's take it, too: actions consist of services and topics.
class NodeWaitablesInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeWaitablesInterface)

  explicit NodeWaitablesInterface(NodeBaseInterface::SharedPtr node) : node_(std::move(node)) {}

  /// To `group`, or to the default one of the node.
  void add_waitable(Waitable::SharedPtr waitable, CallbackGroup::SharedPtr group)
  {
    node_->add(detail::entity_of(waitable), group);
  }
  void remove_waitable(Waitable::SharedPtr waitable, CallbackGroup::SharedPtr group) noexcept
  {
    node_->remove(detail::entity_of(waitable), group);
  }
  NodeBaseInterface::SharedPtr get_node_base_interface() const {return node_;}

private:
  NodeBaseInterface::SharedPtr node_;
};

}  // namespace rclcpp::node_interfaces
