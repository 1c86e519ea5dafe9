#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_time_source_interface.hpp"
#include "rclcpp/node_interfaces/node_timers_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"
#include "rclcpp/node_interfaces/node_waitables_interface.hpp"

namespace rclcpp::node_interfaces
{

/// Chooses one of the functions `part_of`.
template<typename InterfaceT>
struct PartTag {};

// For each part: whether something has the method that returns it, and a function that returns it.
// The function takes a node, a pointer of any kind to a node, or the part itself.
// It throws std::invalid_argument for a null pointer.
#define RCLCPP_DETAIL_GETTER(Interface, name) \
  template<typename NodeT, typename = void> \
  struct has_ ## name : std::false_type {}; \
  template<typename NodeT> \
  struct has_ ## name<NodeT, std::void_t<decltype(std::declval<NodeT &>().get_ ## name())>> \
    : std::true_type {}; \
  template<typename NodeT> \
  std::shared_ptr<Interface> get_ ## name(NodeT && node) \
  { \
    if constexpr (std::is_convertible_v<NodeT, std::shared_ptr<Interface>>) { \
      return node; \
    } else if constexpr (has_ ## name<std::remove_reference_t<NodeT>>::value) { \
      return node.get_ ## name(); \
    } else { \
      if (!node) { \
        throw std::invalid_argument("node cannot be nullptr"); \
      } \
      return node->get_ ## name(); \
    } \
  } \
  template<typename NodeT> \
  std::shared_ptr<Interface> part_of(NodeT & node, PartTag<Interface>) {return node.get_ ## name();}

RCLCPP_DETAIL_GETTER(NodeBaseInterface, node_base_interface)
RCLCPP_DETAIL_GETTER(NodeClockInterface, node_clock_interface)
RCLCPP_DETAIL_GETTER(NodeGraphInterface, node_graph_interface)
RCLCPP_DETAIL_GETTER(NodeLoggingInterface, node_logging_interface)
RCLCPP_DETAIL_GETTER(NodeParametersInterface, node_parameters_interface)
RCLCPP_DETAIL_GETTER(NodeServicesInterface, node_services_interface)
RCLCPP_DETAIL_GETTER(NodeTimeSourceInterface, node_time_source_interface)
RCLCPP_DETAIL_GETTER(NodeTimersInterface, node_timers_interface)
RCLCPP_DETAIL_GETTER(NodeTopicsInterface, node_topics_interface)
RCLCPP_DETAIL_GETTER(NodeTypeDescriptionsInterface, node_type_descriptions_interface)
RCLCPP_DETAIL_GETTER(NodeWaitablesInterface, node_waitables_interface)

#undef RCLCPP_DETAIL_GETTER

}  // namespace rclcpp::node_interfaces
