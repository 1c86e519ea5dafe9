#pragma once

namespace rclcpp
{

/// Whether messages to subscriptions of the same process are handed over without the middleware.
enum class IntraProcessSetting
{
  Enable,
  Disable,
  NodeDefault,
};

}  // namespace rclcpp
