# What the package has registered becomes one entry in each index, from which containers and
# `ros2 component types` know of it.
get_property(_rclcpp_components_indices GLOBAL PROPERTY rclcpp_components_indices)
foreach(_rclcpp_components_index IN LISTS _rclcpp_components_indices)
  get_property(_rclcpp_components_lines GLOBAL PROPERTY rclcpp_components_in_${_rclcpp_components_index})
  ament_index_register_resource(${_rclcpp_components_index} CONTENT "${_rclcpp_components_lines}")
endforeach()
