#include "rclcpp/wait_set_base.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "rclcpp/detail/check.hpp"
#include "wait_set.hpp"

namespace rclcpp
{

namespace
{

using detail::EntityKind;

const Context::SharedPtr & present(const Context::SharedPtr & context)
{
  if (!context) {
    throw std::invalid_argument("context is nullptr");
  }
  return context;
}

template<typename T>
void check_there(const std::shared_ptr<T> & entity, const char * name)
{
  if (!entity) {
    throw std::invalid_argument(std::string(name) + " is nullptr");
  }
}

/// Makes it a member of no other wait set. The words are those of the real one, which differ.
template<typename T>
void take(const std::shared_ptr<T> & entity, const std::string & name)
{
  check_there(entity, name.c_str());
  if (entity->exchange_in_use_by_wait_set_state(true)) {
    const bool is_of_subscription = name.rfind("subscription", 0) == 0;
    throw std::runtime_error(
            (name == "guard_condition" ? "guard condition" : name) +
            (is_of_subscription ? " already associated with a wait set" : " already in use by another wait set"));
  }
}

template<typename T>
void release(const std::weak_ptr<T> & member)
{
  if (const auto entity = member.lock()) {
    entity->exchange_in_use_by_wait_set_state(false);
  }
}

}  // namespace

WaitSetBase::WaitSetBase(Context::SharedPtr context, bool is_shared)
: context_(present(context)), is_shared_(is_shared), interrupt_(context_)
{
  detail::check(
    rcl_wait_set_init(
      &set_, 0, 0, 0, 0, 0, 0, context_->get_rcl_context().get(), rcl_get_default_allocator()),
    "failed to create wait set");
}

WaitSetBase::~WaitSetBase()
{
  for (const auto & member : guard_conditions_) {
    release(member);
  }
  for (const auto & member : members_) {
    release(member.entity);
  }
  if (rcl_wait_set_fini(&set_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

void WaitSetBase::changed()
{
  ++state_;
  if (is_shared_) {
    interrupt_.trigger();
  }
}

void WaitSetBase::add_guard_condition_(const GuardCondition::SharedPtr & guard_condition)
{
  take(guard_condition, "guard_condition");
  const std::lock_guard lock(mutex_);
  guard_conditions_.push_back(guard_condition);
  changed();
}

void WaitSetBase::remove_guard_condition_(const GuardCondition::SharedPtr & guard_condition)
{
  check_there(guard_condition, "guard_condition");
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(
    guard_conditions_.begin(), guard_conditions_.end(),
    [&](const auto & member) {return member.lock() == guard_condition;});
  if (found == guard_conditions_.end()) {
    throw std::runtime_error("guard_condition not in wait set");
  }
  release(*found);
  guard_conditions_.erase(found);
  changed();
}

void WaitSetBase::add_entity_(
  const std::shared_ptr<detail::Entity> & entity, const char * name, const std::shared_ptr<void> & associated)
{
  take(entity, name);
  const std::lock_guard lock(mutex_);
  members_.push_back({entity, associated, associated != nullptr});
  changed();
}

void WaitSetBase::remove_entity_(const std::shared_ptr<detail::Entity> & entity, const char * name)
{
  check_there(entity, name);
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(
    members_.begin(), members_.end(), [&](const auto & member) {return member.entity.lock() == entity;});
  if (found == members_.end()) {
    throw std::runtime_error(std::string(name) + " not in wait set");
  }
  release(found->entity);
  members_.erase(found);
  changed();
}

void WaitSetBase::add_subscription_(
  const SubscriptionBase::SharedPtr & subscription, SubscriptionWaitSetMask mask)
{
  check_there(subscription, "subscription");
  if (mask.include_subscription) {
    add_entity_(subscription, "subscription");
  }
  for (const auto & [type, event] : subscription->get_event_handlers()) {
    if (mask.include_events) {
      add_entity_(event, "subscription event", subscription);
    }
  }
  const auto inbox = subscription->companion();
  if (inbox && mask.include_intra_process_waitable) {
    add_entity_(inbox, "subscription intra process waitable", subscription);
  }
}

void WaitSetBase::remove_subscription_(
  const SubscriptionBase::SharedPtr & subscription, SubscriptionWaitSetMask mask)
{
  check_there(subscription, "subscription");
  if (mask.include_subscription) {
    remove_entity_(subscription, "subscription");
  }
  for (const auto & [type, event] : subscription->get_event_handlers()) {
    if (mask.include_events) {
      remove_entity_(event, "subscription event");
    }
  }
  const auto inbox = subscription->companion();
  if (inbox && mask.include_intra_process_waitable) {
    remove_entity_(inbox, "subscription intra process waitable");
  }
}

void WaitSetBase::prune_()
{
  const std::lock_guard lock(mutex_);
  guard_conditions_.erase(
    std::remove_if(
      guard_conditions_.begin(), guard_conditions_.end(), [](const auto & one) {return one.expired();}),
    guard_conditions_.end());
  const auto is_gone = [](const Member & one) {
      return one.entity.expired() || (one.has_associated && one.associated.expired());
    };
  members_.erase(std::remove_if(members_.begin(), members_.end(), is_gone), members_.end());
}

void WaitSetBase::hold()
{
  Held held;
  const std::lock_guard lock(mutex_);
  for (const auto & member : guard_conditions_) {
    if (auto one = member.lock()) {
      held.guard_conditions.push_back(std::move(one));
    }
  }
  for (const auto & member : members_) {
    auto entity = member.entity.lock();
    auto associated = member.associated.lock();
    if (!entity || (member.has_associated && !associated)) {
      continue;
    }
    switch (entity->kind()) {
      case EntityKind::subscription:
        held.subscriptions.push_back(std::static_pointer_cast<SubscriptionBase>(entity));
        break;
      case EntityKind::timer:
        held.timers.push_back(std::static_pointer_cast<TimerBase>(entity));
        break;
      case EntityKind::client:
        held.clients.push_back(std::static_pointer_cast<ClientBase>(entity));
        break;
      case EntityKind::service:
        held.services.push_back(std::static_pointer_cast<ServiceBase>(entity));
        break;
      default:
        held.others.push_back(std::move(entity));
    }
    held.associated.push_back(std::move(associated));
  }
  held_ = std::move(held);
}

void WaitSetBase::fill()
{
  detail::WaitSetRoom room;
  room.subscriptions = held_.subscriptions.size();
  room.guard_conditions = held_.guard_conditions.size() + is_shared_;
  room.timers = held_.timers.size();
  room.clients = held_.clients.size();
  room.services = held_.services.size();
  for (const auto & other : held_.others) {
    room.add(*other);
  }
  detail::check(room.resize(set_), "failed to resize the wait set");
  for (const auto & one : held_.guard_conditions) {
    detail::check(
      rcl_wait_set_add_guard_condition(&set_, &one->get_rcl_guard_condition(), nullptr),
      "failed to add a guard condition to the wait set");
  }
  const auto add = [&](const auto & entities) {
      for (const auto & entity : entities) {
        entity->before_wait();
        std::size_t index = 0;
        detail::check(detail::add_to_wait_set(set_, *entity, index), "failed to add to the wait set");
      }
    };
  add(held_.subscriptions);
  add(held_.timers);
  add(held_.clients);
  add(held_.services);
  add(held_.others);
  if (is_shared_) {
    detail::check(
      rcl_wait_set_add_guard_condition(&set_, &interrupt_.get_rcl_guard_condition(), nullptr),
      "failed to add a guard condition to the wait set");
  }
}

/// Whether nothing is ready but that members have come or gone.
bool WaitSetBase::is_only_interrupted() const
{
  const auto any = [](const auto & array, std::size_t size) {
      return std::any_of(array, array + size, [](const void * one) {return one != nullptr;});
    };
  return is_shared_ && set_.guard_conditions[set_.size_of_guard_conditions - 1] &&
         !any(set_.subscriptions, set_.size_of_subscriptions) &&
         !any(set_.guard_conditions, set_.size_of_guard_conditions - 1) &&
         !any(set_.timers, set_.size_of_timers) && !any(set_.clients, set_.size_of_clients) &&
         !any(set_.services, set_.size_of_services) && !any(set_.events, set_.size_of_events);
}

WaitResultKind WaitSetBase::wait_(std::chrono::nanoseconds time_to_wait)
{
  using Steady = std::chrono::steady_clock;
  const std::lock_guard lock(waiting_mutex_);
  const auto began = Steady::now();
  while (true) {
    hold();
    const bool is_empty = held_.guard_conditions.empty() && held_.subscriptions.empty() &&
      held_.timers.empty() && held_.clients.empty() && held_.services.empty() && held_.others.empty();
    ++state_;
    if (is_empty && !is_shared_) {
      return WaitResultKind::Empty;
    }
    fill();
    const auto left = time_to_wait.count() < 0 ? time_to_wait : std::max(
      std::chrono::nanoseconds(0), time_to_wait - (Steady::now() - began));
    const rcl_ret_t ret = rcl_wait(&set_, left.count());
    if (ret == RCL_RET_TIMEOUT) {
      rcl_reset_error();
      return WaitResultKind::Timeout;
    }
    if (ret == RCL_RET_WAIT_SET_EMPTY) {  // there are waitables that wait for nothing
      rcl_reset_error();
      return WaitResultKind::Empty;
    }
    detail::check(ret, "rcl_wait() failed");
    if (!is_only_interrupted()) {
      return WaitResultKind::Ready;
    }
  }
}

}  // namespace rclcpp
