# Writes one entry to each index for what the package has registered. Containers and
# `ros2 component types` find it there.
get_property(_rclcpp_components_indices GLOBAL PROPERTY rclcpp_components_indices)
foreach(_rclcpp_components_index IN LISTS _rclcpp_components_indices)
  get_property(_rclcpp_components_lines GLOBAL PROPERTY rclcpp_components_in_${_rclcpp_components_index})
  ament_index_register_resource(${_rclcpp_components_index} CONTENT "${_rclcpp_components_lines}")
endforeach()
