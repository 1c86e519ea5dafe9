#include "rclcpp/callback_group.hpp"

#include <algorithm>
#include <utility>

namespace rclcpp
{

CallbackGroup::CallbackGroup(CallbackGroupType group_type, bool automatically_add_to_executor_with_node)
: CallbackGroup(group_type, std::weak_ptr<Context>(), automatically_add_to_executor_with_node)
{
}

CallbackGroup::CallbackGroup(
  CallbackGroupType group_type, std::weak_ptr<Context> context, bool automatically_add_to_executor_with_node)
: type_(group_type), automatic_(automatically_add_to_executor_with_node), context_(std::move(context))
{
}

std::size_t CallbackGroup::size() const
{
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
           entities_.begin(), entities_.end(), [](const auto & known) {return !known.expired();}));
}

void CallbackGroup::collect(std::vector<std::shared_ptr<detail::Entity>> & found)
{
  const std::lock_guard lock(mutex_);
  bool gone = false;
  for (const auto & known : entities_) {
    if (auto entity = known.lock()) {
      found.push_back(std::move(entity));
    } else {
      gone = true;
    }
  }
  if (gone) {
    entities_.erase(
      std::remove_if(
        entities_.begin(), entities_.end(), [](const auto & known) {return known.expired();}),
      entities_.end());
  }
}

void CallbackGroup::add(const std::shared_ptr<detail::Entity> & entity)
{
  std::unique_lock lock(mutex_);
  entities_.push_back(entity);
  const auto waker = waker_.lock();
  const auto notify = notify_;
  lock.unlock();
  for (const auto & one : {waker, notify}) {
    if (one) {
      one->trigger();
    }
  }
}

void CallbackGroup::remove(const std::shared_ptr<detail::Entity> & entity)
{
  const std::lock_guard lock(mutex_);
  entities_.erase(
    std::remove_if(
      entities_.begin(), entities_.end(), [&](const auto & known) {return known.lock() == entity;}),
    entities_.end());
}

std::shared_ptr<GuardCondition> CallbackGroup::get_notify_guard_condition()
{
  const auto context = context_.lock();
  const std::lock_guard lock(mutex_);
  if (!context || !context->is_valid()) {
    notify_ = nullptr;
  } else if (!notify_) {
    notify_ = std::make_shared<GuardCondition>(context);
  }
  return notify_;
}

void CallbackGroup::set_waker(const std::shared_ptr<GuardCondition> & waker)
{
  const std::lock_guard lock(mutex_);
  waker_ = waker;
}

}  // namespace rclcpp
