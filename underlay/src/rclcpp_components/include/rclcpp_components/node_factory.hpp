#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "class_loader/registry.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp_components/node_instance_wrapper.hpp"

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

/// Of the class of nodes with this name, if a library that is loaded has registered it; else nothing.
inline std::shared_ptr<NodeFactory> factory_of(const std::string & node_class)
{
  auto & registry = class_loader::detail::registry_of<NodeFactory>();
  const std::lock_guard lock(registry.mutex);
  const auto found = registry.entries.find("rclcpp_components::NodeFactoryTemplate<" + node_class + ">");
  return std::shared_ptr<NodeFactory>(
    found == registry.entries.end() ? nullptr : static_cast<NodeFactory *>(found->second.make()));
}

}  // namespace detail
}  // namespace rclcpp_components
