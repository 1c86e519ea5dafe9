#pragma once

#include <map>
#include <memory>
#include <string>

#include "rclcpp/node_options.hpp"
#include "rclcpp_components/node_instance_wrapper.hpp"
#include "rclcpp_components/visibility_control.hpp"

namespace rclcpp_components
{

/// Makes nodes of one class.
class NodeFactory
{
public:
  virtual ~NodeFactory() = default;
  virtual NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions & options) = 0;
};

namespace detail
{

/// Of all libraries that are loaded, by the name of the class as it was registered.
RCLCPP_COMPONENTS_PUBLIC inline std::map<std::string, std::shared_ptr<NodeFactory>> & factories()
{
  static std::map<std::string, std::shared_ptr<NodeFactory>> instance;
  return instance;
}

}  // namespace detail
}  // namespace rclcpp_components
