#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl/wait.h"
#include "rclcpp/client.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/subscription_wait_set_mask.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/waitable.hpp"
#include "rclcpp/wait_result_kind.hpp"

namespace rclcpp
{

/// What wait sets of all kinds have in common. Members are not kept alive, except from the beginning of a wait
/// to the beginning of the next.
class WaitSetBase
{
public:
  struct SubscriptionEntry
  {
    SubscriptionEntry(  // NOLINT: a subscription alone is one
      SubscriptionBase::SharedPtr subscription_in = nullptr, SubscriptionWaitSetMask mask_in = {})
    : subscription(std::move(subscription_in)), mask(mask_in) {}

    SubscriptionBase::SharedPtr subscription;
    SubscriptionWaitSetMask mask;
  };

  /// Whatever else can be waited for, and what must live as long.
  struct WaitableEntry
  {
    WaitableEntry(  // NOLINT: a waitable alone is one
      std::shared_ptr<detail::Entity> waitable_in = nullptr, std::shared_ptr<void> associated_in = nullptr)
    : waitable(std::move(waitable_in)), associated_entity(std::move(associated_in)) {}
    template<typename WaitableT, std::enable_if_t<std::is_base_of_v<Waitable, WaitableT>, int> = 0>
    WaitableEntry(  // NOLINT: the same
      const std::shared_ptr<WaitableT> & waitable_in, std::shared_ptr<void> associated_in = nullptr)
    : WaitableEntry(detail::entity_of(waitable_in), std::move(associated_in)) {}

    std::shared_ptr<detail::Entity> waitable;
    std::shared_ptr<void> associated_entity;
  };

  WaitSetBase(const WaitSetBase &) = delete;
  WaitSetBase & operator=(const WaitSetBase &) = delete;

  /// As the last wait left it: what was not ready is a null pointer.
  const rcl_wait_set_t & get_rcl_wait_set() const {return set_;}

  // Of the last wait, in the order in which they were added.
  std::size_t size_of_subscriptions() const {return held_.subscriptions.size();}
  std::size_t size_of_timers() const {return held_.timers.size();}
  std::size_t size_of_clients() const {return held_.clients.size();}
  std::size_t size_of_services() const {return held_.services.size();}
  SubscriptionBase::SharedPtr subscriptions(std::size_t index) const {return held_.subscriptions[index];}
  TimerBase::SharedPtr timers(std::size_t index) const {return held_.timers[index];}
  ClientBase::SharedPtr clients(std::size_t index) const {return held_.clients[index];}
  ServiceBase::SharedPtr services(std::size_t index) const {return held_.services[index];}

  /// Another number after each change and each wait.
  std::size_t state() const {return state_;}
  rcl_wait_set_t & changeable_rcl_wait_set() {return set_;}

protected:
  /// Throws std::invalid_argument without a context, RCLInvalidArgument for one that was not initialized.
  /// With `is_shared`, members may come and go in other threads, also during a wait.
  WaitSetBase(Context::SharedPtr context, bool is_shared);
  ~WaitSetBase();

  // All of these throw std::invalid_argument for a null pointer, and std::runtime_error for what is in a wait
  // set already, or is not in this one.
  void add_guard_condition_(const GuardCondition::SharedPtr & guard_condition);
  void remove_guard_condition_(const GuardCondition::SharedPtr & guard_condition);
  void add_subscription_(const SubscriptionBase::SharedPtr & subscription, SubscriptionWaitSetMask mask);
  void remove_subscription_(const SubscriptionBase::SharedPtr & subscription, SubscriptionWaitSetMask mask);
  void add_entity_(
    const std::shared_ptr<detail::Entity> & entity, const char * name,
    const std::shared_ptr<void> & associated = nullptr);
  void remove_entity_(const std::shared_ptr<detail::Entity> & entity, const char * name);
  void prune_();

  /// A negative time waits for ever. Throws RCLError.
  WaitResultKind wait_(std::chrono::nanoseconds time_to_wait);

private:
  struct Member
  {
    std::weak_ptr<detail::Entity> entity;
    std::weak_ptr<void> associated;
    bool has_associated;
  };

  struct Held
  {
    std::vector<GuardCondition::SharedPtr> guard_conditions;
    std::vector<SubscriptionBase::SharedPtr> subscriptions;
    std::vector<TimerBase::SharedPtr> timers;
    std::vector<ClientBase::SharedPtr> clients;
    std::vector<ServiceBase::SharedPtr> services;
    std::vector<std::shared_ptr<detail::Entity>> others;  // events, and inboxes of subscriptions
    std::vector<std::shared_ptr<void>> associated;
  };

  void changed();
  void hold();
  void fill();
  bool is_only_interrupted() const;

  Context::SharedPtr context_;
  const bool is_shared_;
  GuardCondition interrupt_;
  std::mutex waiting_mutex_;
  mutable std::mutex mutex_;
  std::vector<std::weak_ptr<GuardCondition>> guard_conditions_;
  std::vector<Member> members_;
  std::atomic<std::size_t> state_{0};
  Held held_;
  rcl_wait_set_t set_ = rcl_get_zero_initialized_wait_set();
};

}  // namespace rclcpp
