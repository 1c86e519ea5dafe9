#include "rclcpp/guard_condition.hpp"

#include <stdexcept>

#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

GuardCondition::GuardCondition(const Context::SharedPtr & context)
: context_(context ? context->get_rcl_context() : nullptr),
  guard_condition_(rcl_get_zero_initialized_guard_condition())
{
  if (!context) {
    throw std::invalid_argument("context argument unexpectedly nullptr");
  }
  detail::check(
    rcl_guard_condition_init(
      &guard_condition_, context_.get(), rcl_guard_condition_get_default_options()),
    "failed to create guard condition");
}

GuardCondition::~GuardCondition()
{
  if (rcl_guard_condition_fini(&guard_condition_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

void GuardCondition::trigger()
{
  detail::check(rcl_trigger_guard_condition(&guard_condition_), "failed to trigger guard condition");
}

}  // namespace rclcpp
