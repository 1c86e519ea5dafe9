#pragma once

#include <memory>
#include <tuple>
#include <utility>

#include "rclcpp/node_interfaces/getters.hpp"

/// All parts of a node, for the template below.
#define ALL_RCLCPP_NODE_INTERFACES \
  rclcpp::node_interfaces::NodeBaseInterface, \
  rclcpp::node_interfaces::NodeClockInterface, \
  rclcpp::node_interfaces::NodeGraphInterface, \
  rclcpp::node_interfaces::NodeLoggingInterface, \
  rclcpp::node_interfaces::NodeParametersInterface, \
  rclcpp::node_interfaces::NodeServicesInterface, \
  rclcpp::node_interfaces::NodeTimeSourceInterface, \
  rclcpp::node_interfaces::NodeTimersInterface, \
  rclcpp::node_interfaces::NodeTopicsInterface, \
  rclcpp::node_interfaces::NodeTypeDescriptionsInterface, \
  rclcpp::node_interfaces::NodeWaitablesInterface

namespace rclcpp::node_interfaces
{

/// Parts of a node, of whatever class that is. It is made of a node, of another one, or of the parts themselves.
template<typename ... InterfaceTs>
class NodeInterfaces
{
  static_assert(sizeof...(InterfaceTs) > 0, "must provide at least one interface as a template argument");

public:
  NodeInterfaces() = default;
  template<typename NodeT>
  NodeInterfaces(NodeT & node)  // NOLINT: a node stands for its parts
  : parts_(part_of(node, PartTag<InterfaceTs>()) ...) {}
  explicit NodeInterfaces(std::shared_ptr<InterfaceTs>... parts) : parts_(std::move(parts) ...) {}

  template<typename InterfaceT>
  std::shared_ptr<InterfaceT> get() const {return std::get<std::shared_ptr<InterfaceT>>(parts_);}
  template<typename InterfaceT>
  void set(std::shared_ptr<InterfaceT> part)
  {
    std::get<std::shared_ptr<InterfaceT>>(parts_) = std::move(part);
  }

  // These compile where the part is one of them.
  auto get_node_base_interface() const {return get<NodeBaseInterface>();}
  auto get_node_clock_interface() const {return get<NodeClockInterface>();}
  auto get_node_graph_interface() const {return get<NodeGraphInterface>();}
  auto get_node_logging_interface() const {return get<NodeLoggingInterface>();}
  auto get_node_parameters_interface() const {return get<NodeParametersInterface>();}
  auto get_node_services_interface() const {return get<NodeServicesInterface>();}
  auto get_node_time_source_interface() const {return get<NodeTimeSourceInterface>();}
  auto get_node_timers_interface() const {return get<NodeTimersInterface>();}
  auto get_node_topics_interface() const {return get<NodeTopicsInterface>();}
  auto get_node_type_descriptions_interface() const {return get<NodeTypeDescriptionsInterface>();}
  auto get_node_waitables_interface() const {return get<NodeWaitablesInterface>();}

private:
  std::tuple<std::shared_ptr<InterfaceTs>...> parts_;
};

}  // namespace rclcpp::node_interfaces
