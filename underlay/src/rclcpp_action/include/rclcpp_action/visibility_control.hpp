#pragma once

#define RCLCPP_ACTION_PUBLIC
#define RCLCPP_ACTION_LOCAL
