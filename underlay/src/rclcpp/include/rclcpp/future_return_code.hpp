#pragma once

#include <ostream>
#include <string>

namespace rclcpp
{

/// How waiting for a future ended.
enum class FutureReturnCode
{
  SUCCESS,
  INTERRUPTED,
  TIMEOUT,
};

std::string to_string(const FutureReturnCode & future_return_code);
std::ostream & operator<<(std::ostream & os, const FutureReturnCode & future_return_code);

}  // namespace rclcpp
