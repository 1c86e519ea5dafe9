#pragma once

#include "class_loader/register_macro.hpp"
#include "rclcpp_components/node_factory_template.hpp"

/// Makes a class of nodes known by its full name when the library is loaded. Once for each class, outside of
/// any namespace.
#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) \
  CLASS_LOADER_REGISTER_CLASS(rclcpp_components::NodeFactoryTemplate<NodeClass>, rclcpp_components::NodeFactory)
