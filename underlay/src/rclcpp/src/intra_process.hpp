#pragma once

#include "rclcpp/intra_process_setting.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp::detail
{

/// Whether an entity of the node with this setting hands messages over within the process.
inline bool uses_intra_process(
  IntraProcessSetting setting, const node_interfaces::NodeBaseInterface & node)
{
  return setting == IntraProcessSetting::NodeDefault ? node.get_use_intra_process_default() :
         setting == IntraProcessSetting::Enable;
}

}  // namespace rclcpp::detail
