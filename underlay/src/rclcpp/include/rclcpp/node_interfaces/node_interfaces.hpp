#pragma once

#include <memory>
#include <tuple>
#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_timers_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/node_interfaces/node_waitables_interface.hpp"

namespace rclcpp::node_interfaces
{

namespace detail
{

template<typename InterfaceT>
struct Asked {};

// What a node is asked for, by the interface that is wanted.
template<typename NodeT>
auto of(NodeT & node, Asked<NodeBaseInterface>) {return node.get_node_base_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeClockInterface>) {return node.get_node_clock_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeGraphInterface>) {return node.get_node_graph_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeLoggingInterface>) {return node.get_node_logging_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeParametersInterface>) {return node.get_node_parameters_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeServicesInterface>) {return node.get_node_services_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeTimersInterface>) {return node.get_node_timers_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeTopicsInterface>) {return node.get_node_topics_interface();}
template<typename NodeT>
auto of(NodeT & node, Asked<NodeWaitablesInterface>) {return node.get_node_waitables_interface();}

}  // namespace detail

/// Parts of a node, of whatever class that is. It is made of a node, of another one, or of the parts themselves.
template<typename ... InterfaceTs>
class NodeInterfaces
{
  static_assert(sizeof...(InterfaceTs) > 0, "must provide at least one interface as a template argument");

public:
  NodeInterfaces() = default;
  template<typename NodeT>
  NodeInterfaces(NodeT & node)  // NOLINT: a node stands for its parts
  : parts_(detail::of(node, detail::Asked<InterfaceTs>()) ...) {}
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
  auto get_node_timers_interface() const {return get<NodeTimersInterface>();}
  auto get_node_topics_interface() const {return get<NodeTopicsInterface>();}
  auto get_node_waitables_interface() const {return get<NodeWaitablesInterface>();}

private:
  std::tuple<std::shared_ptr<InterfaceTs>...> parts_;
};

}  // namespace rclcpp::node_interfaces
