#pragma once

// Everything is visible outside of the library; the names are for sources that use them.
#define RCLCPP_EXPORT
#define RCLCPP_IMPORT
#define RCLCPP_PUBLIC
#define RCLCPP_PUBLIC_TYPE
#define RCLCPP_LOCAL
