#include "rclcpp/wait_for_message.hpp"

#include <vector>

#include "wait_set.hpp"

namespace rclcpp::detail
{

bool wait_for_subscription(
  const std::shared_ptr<SubscriptionBase> & subscription, const Context::SharedPtr & context,
  std::chrono::nanoseconds time_to_wait)
{
  const auto interrupt = std::make_shared<GuardCondition>(context);
  const auto handle = context->add_on_shutdown_callback([interrupt]() {interrupt->trigger();});
  bool is_ready = false;
  if (context->is_valid()) {
    WaitSet set(context);
    const std::vector<std::shared_ptr<Entity>> entities{subscription};
    is_ready = set.wait(entities, *interrupt, time_to_wait) && set.is_ready(0);
  }
  context->remove_on_shutdown_callback(handle);
  return is_ready;
}

}  // namespace rclcpp::detail
