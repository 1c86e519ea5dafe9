#pragma once

#include <memory>

#include "rclcpp_components/node_factory_template.hpp"

#define RCLCPP_COMPONENTS_DO_JOIN(first, second) first ## second
#define RCLCPP_COMPONENTS_JOIN(first, second) RCLCPP_COMPONENTS_DO_JOIN(first, second)

/// Makes a class of nodes known by its full name when the library is loaded. Once for each class, outside of
/// any namespace.
#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) \
  static const bool RCLCPP_COMPONENTS_JOIN(rclcpp_components_registered_, __COUNTER__) = \
    rclcpp_components::detail::factories().insert_or_assign( \
    #NodeClass, std::make_shared<rclcpp_components::NodeFactoryTemplate<NodeClass>>()).second;
