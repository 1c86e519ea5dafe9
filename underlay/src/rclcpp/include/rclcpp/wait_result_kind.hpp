#pragma once

namespace rclcpp
{

/// What came of waiting.
enum class WaitResultKind
{
  Ready,    ///< something is ready
  Timeout,  ///< nothing was within the time
  Empty,    ///< there is nothing to wait for
  Invalid,  ///< the wait set was changed after the waiting
};

}  // namespace rclcpp
