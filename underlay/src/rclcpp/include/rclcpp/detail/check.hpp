#pragma once

#include <string>

#include "rclcpp/exceptions.hpp"

namespace rclcpp::detail
{

/// Throws what fits when a function of rcl did not succeed; `doing` says what was tried.
inline void check(rcl_ret_t ret, const char * doing)
{
  if (ret != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(ret, doing);
  }
}

}  // namespace rclcpp::detail
