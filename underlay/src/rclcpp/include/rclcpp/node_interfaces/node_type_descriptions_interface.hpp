#pragma once

#include <memory>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp::node_interfaces
{

/// The service `~/get_type_description`, unless the parameter start_type_description_service says no.
class NodeTypeDescriptionsInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTypeDescriptionsInterface)

  NodeTypeDescriptionsInterface(
    const NodeBaseInterface::SharedPtr & node, NodeParametersInterface & parameters);

private:
  std::shared_ptr<void> service_;
};

}  // namespace rclcpp::node_interfaces
