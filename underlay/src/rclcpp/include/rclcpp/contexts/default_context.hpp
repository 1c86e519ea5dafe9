#pragma once

#include "rclcpp/context.hpp"

namespace rclcpp::contexts
{

class DefaultContext : public Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(DefaultContext)
  DefaultContext() = default;
};

/// The context of everything that does not name another one.
DefaultContext::SharedPtr get_global_default_context();

}  // namespace rclcpp::contexts
