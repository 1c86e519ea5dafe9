#include "rclcpp/guard_condition.hpp"

#include <stdexcept>
#include <utility>

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
  const std::lock_guard lock(mutex_);
  if (on_trigger_) {
    on_trigger_(1);
  } else {
    ++unread_;
  }
}

void GuardCondition::add_to_wait_set(rcl_wait_set_t & wait_set)
{
  const std::lock_guard lock(mutex_);
  if (exchange_in_use_by_wait_set_state(true) && &wait_set != wait_set_) {
    throw std::runtime_error("guard condition has already been added to a wait set.");
  }
  wait_set_ = &wait_set;
  detail::check(
    rcl_wait_set_add_guard_condition(&wait_set, &guard_condition_, nullptr),
    "failed to add guard condition to wait set");
}

void GuardCondition::set_on_trigger_callback(std::function<void(std::size_t)> callback)
{
  const std::lock_guard lock(mutex_);
  on_trigger_ = std::move(callback);
  if (on_trigger_ && unread_ > 0) {
    on_trigger_(unread_);
    unread_ = 0;
  }
}

}  // namespace rclcpp
