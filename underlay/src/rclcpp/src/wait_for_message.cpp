#include "rclcpp/wait_for_message.hpp"

#include <utility>
#include <vector>

#include "wait_set.hpp"

namespace rclcpp::detail
{

namespace
{

/// Triggers a condition when the context ends, as long as this lives.
class EndOf
{
public:
  explicit EndOf(Context::SharedPtr context)
  : context_(std::move(context)), condition_(std::make_shared<GuardCondition>(context_)),
    handle_(context_->add_on_shutdown_callback([condition = condition_]() {condition->trigger();}))
  {
  }
  EndOf(const EndOf &) = delete;
  EndOf & operator=(const EndOf &) = delete;
  ~EndOf() {context_->remove_on_shutdown_callback(handle_);}
  const GuardCondition & condition() const {return *condition_;}

private:
  Context::SharedPtr context_;
  std::shared_ptr<GuardCondition> condition_;
  OnShutdownCallbackHandle handle_;
};

}  // namespace

bool wait_for_subscription(
  const std::shared_ptr<SubscriptionBase> & subscription, const Context::SharedPtr & context,
  std::chrono::nanoseconds time_to_wait)
{
  const EndOf end(context);
  if (!context->is_valid()) {
    return false;
  }
  WaitSet set(context);
  const std::vector<std::shared_ptr<Entity>> entities{subscription};
  return set.wait(entities, end.condition(), time_to_wait) && set.is_ready(0);
}

}  // namespace rclcpp::detail
