#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rclcpp/wait_result.hpp"
#include "rclcpp/wait_set_base.hpp"

namespace rclcpp
{

namespace detail
{

/// A wait set to which members can be added.
template<bool is_shared>
class DynamicWaitSet : public WaitSetBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(DynamicWaitSet)

  explicit DynamicWaitSet(
    const std::vector<SubscriptionEntry> & subscriptions = {},
    const std::vector<GuardCondition::SharedPtr> & guard_conditions = {},
    const std::vector<TimerBase::SharedPtr> & timers = {},
    const std::vector<ClientBase::SharedPtr> & clients = {},
    const std::vector<ServiceBase::SharedPtr> & services = {},
    const std::vector<WaitableEntry> & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context())
  : WaitSetBase(std::move(context), is_shared)
  {
    for (const auto & entry : subscriptions) {
      add_subscription(entry.subscription, entry.mask);
    }
    for (const auto & one : guard_conditions) {
      add_guard_condition(one);
    }
    for (const auto & one : timers) {
      add_timer(one);
    }
    for (const auto & one : clients) {
      add_client(one);
    }
    for (const auto & one : services) {
      add_service(one);
    }
    for (const auto & entry : waitables) {
      add_waitable(entry.waitable, entry.associated_entity);
    }
  }

  void add_subscription(SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask = {})
  {
    add_subscription_(subscription, mask);
  }
  void remove_subscription(SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask = {})
  {
    remove_subscription_(subscription, mask);
  }
  void add_guard_condition(GuardCondition::SharedPtr one) {add_guard_condition_(one);}
  void remove_guard_condition(GuardCondition::SharedPtr one) {remove_guard_condition_(one);}
  void add_timer(TimerBase::SharedPtr timer) {add_entity_(timer, "timer");}
  void remove_timer(TimerBase::SharedPtr timer) {remove_entity_(timer, "timer");}
  void add_client(ClientBase::SharedPtr client) {add_entity_(client, "client");}
  void remove_client(ClientBase::SharedPtr client) {remove_entity_(client, "client");}
  void add_service(ServiceBase::SharedPtr service) {add_entity_(service, "service");}
  void remove_service(ServiceBase::SharedPtr service) {remove_entity_(service, "service");}
  void add_waitable(std::shared_ptr<Entity> waitable, std::shared_ptr<void> associated_entity = nullptr)
  {
    add_entity_(waitable, "waitable", associated_entity);
  }
  template<typename WaitableT, std::enable_if_t<std::is_base_of_v<Waitable, WaitableT>, int> = 0>
  void add_waitable(
    const std::shared_ptr<WaitableT> & waitable, std::shared_ptr<void> associated_entity = nullptr)
  {
    add_entity_(entity_of(waitable), "waitable", associated_entity);
  }
  void remove_waitable(std::shared_ptr<Entity> waitable) {remove_entity_(waitable, "waitable");}
  template<typename WaitableT, std::enable_if_t<std::is_base_of_v<Waitable, WaitableT>, int> = 0>
  void remove_waitable(const std::shared_ptr<WaitableT> & waitable)
  {
    remove_entity_(entity_of(waitable), "waitable");
  }
  /// Forgets what does not exist any more. Waiting does so, too.
  void prune_deleted_entities() {prune_();}

  /// Waits until something is ready; a negative time waits for ever.
  template<class Rep = std::int64_t, class Period = std::milli>
  WaitResult<DynamicWaitSet> wait(
    std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
  {
    const auto kind = wait_(std::chrono::duration_cast<std::chrono::nanoseconds>(time_to_wait));
    return WaitResult<DynamicWaitSet>(kind, *this);
  }
};

}  // namespace detail

/// Waits for members in one thread, without an executor.
using WaitSet = detail::DynamicWaitSet<false>;

/// Members may be added and removed while another thread waits.
using ThreadSafeWaitSet = detail::DynamicWaitSet<true>;

/// Has the same members for ever, and keeps them alive.
template<
  std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardCondtions, std::size_t NumberOfTimers,
  std::size_t NumberOfClients, std::size_t NumberOfServices, std::size_t NumberOfWaitables>
class StaticWaitSet : public WaitSetBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(StaticWaitSet)

  explicit StaticWaitSet(
    const std::array<SubscriptionEntry, NumberOfSubscriptions> & subscriptions = {},
    const std::array<GuardCondition::SharedPtr, NumberOfGuardCondtions> & guard_conditions = {},
    const std::array<TimerBase::SharedPtr, NumberOfTimers> & timers = {},
    const std::array<ClientBase::SharedPtr, NumberOfClients> & clients = {},
    const std::array<ServiceBase::SharedPtr, NumberOfServices> & services = {},
    const std::array<WaitableEntry, NumberOfWaitables> & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context())
  : WaitSetBase(std::move(context), false)
  {
    for (const auto & entry : subscriptions) {
      add_subscription_(entry.subscription, entry.mask);
      kept_.push_back(entry.subscription);
    }
    for (const auto & one : guard_conditions) {
      add_guard_condition_(one);
      kept_.push_back(one);
    }
    add_all(timers, "timer");
    add_all(clients, "client");
    add_all(services, "service");
    for (const auto & entry : waitables) {
      add_entity_(entry.waitable, "waitable", entry.associated_entity);
      kept_.push_back(entry.waitable);
      kept_.push_back(entry.associated_entity);
    }
  }

  /// Waits until something is ready; a negative time waits for ever.
  template<class Rep = std::int64_t, class Period = std::milli>
  WaitResult<StaticWaitSet> wait(
    std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
  {
    const auto kind = wait_(std::chrono::duration_cast<std::chrono::nanoseconds>(time_to_wait));
    return WaitResult<StaticWaitSet>(kind, *this);
  }

private:
  template<typename ArrayT>
  void add_all(const ArrayT & entities, const char * name)
  {
    for (const auto & entity : entities) {
      add_entity_(entity, name);
      kept_.push_back(entity);
    }
  }

  std::vector<std::shared_ptr<void>> kept_;
};

}  // namespace rclcpp
