#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp_components
{

/// A node of any class that has an interface for executors.
class NodeInstanceWrapper
{
public:
  using NodeBaseInterfaceGetter = std::function<
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr(const std::shared_ptr<void> &)>;

  NodeInstanceWrapper() = default;
  NodeInstanceWrapper(std::shared_ptr<void> node_instance, NodeBaseInterfaceGetter node_base_interface_getter)
  : node_(std::move(node_instance)), base_of_(std::move(node_base_interface_getter))
  {
  }

  const std::shared_ptr<void> get_node_instance() const {return node_;}
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return base_of_(node_);}

private:
  std::shared_ptr<void> node_;
  NodeBaseInterfaceGetter base_of_;
};

}  // namespace rclcpp_components
