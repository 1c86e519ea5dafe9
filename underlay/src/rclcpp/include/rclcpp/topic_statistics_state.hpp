#pragma once

namespace rclcpp
{

enum class TopicStatisticsState
{
  Enable,
  Disable,
  NodeDefault,
};

}  // namespace rclcpp
