#pragma once

#include "rcl/arguments.h"

namespace rclcpp::detail
{

/// Configures logging while at least one of these lives; what configures first counts.
class Logging
{
public:
  explicit Logging(const rcl_arguments_t & arguments);
  Logging(const Logging &) = delete;
  Logging & operator=(const Logging &) = delete;
  ~Logging();
};

}  // namespace rclcpp::detail
