#include "wait_set.hpp"

#include "rclcpp/detail/check.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp::detail
{

namespace
{

template<typename T>
const T * as(const Entity & entity)
{
  return static_cast<const T *>(entity.rcl_entity());
}

Waitable & waitable_of(const Entity & entity)
{
  return static_cast<const WaitableEntity &>(entity).waitable();
}

}  // namespace

rcl_ret_t add_to_wait_set(rcl_wait_set_t & set, const Entity & entity, std::size_t & index)
{
  switch (entity.kind()) {
    case EntityKind::timer:
      return rcl_wait_set_add_timer(&set, as<rcl_timer_t>(entity), &index);
    case EntityKind::subscription:
      return rcl_wait_set_add_subscription(&set, as<rcl_subscription_t>(entity), &index);
    case EntityKind::service:
      return rcl_wait_set_add_service(&set, as<rcl_service_t>(entity), &index);
    case EntityKind::client:
      return rcl_wait_set_add_client(&set, as<rcl_client_t>(entity), &index);
    case EntityKind::event:
      return rcl_wait_set_add_event(&set, as<rcl_event_t>(entity), &index);
    case EntityKind::waitable:
      waitable_of(entity).add_to_wait_set(set);
      return RCL_RET_OK;
    default:
      return rcl_wait_set_add_guard_condition(&set, as<rcl_guard_condition_t>(entity), &index);
  }
}

void WaitSetRoom::add(const Entity & entity)
{
  switch (entity.kind()) {
    case EntityKind::timer:
      ++timers;
      break;
    case EntityKind::subscription:
      ++subscriptions;
      break;
    case EntityKind::service:
      ++services;
      break;
    case EntityKind::client:
      ++clients;
      break;
    case EntityKind::event:
      ++events;
      break;
    case EntityKind::guard_condition:
      ++guard_conditions;
      break;
    case EntityKind::waitable:
      auto & waitable = waitable_of(entity);
      subscriptions += waitable.get_number_of_ready_subscriptions();
      guard_conditions += waitable.get_number_of_ready_guard_conditions();
      timers += waitable.get_number_of_ready_timers();
      clients += waitable.get_number_of_ready_clients();
      services += waitable.get_number_of_ready_services();
      events += waitable.get_number_of_ready_events();
  }
}

bool WaitSetRoom::fits(const rcl_wait_set_t & set) const
{
  return set.size_of_subscriptions == subscriptions && set.size_of_guard_conditions == guard_conditions &&
         set.size_of_timers == timers && set.size_of_clients == clients &&
         set.size_of_services == services && set.size_of_events == events;
}

rcl_ret_t WaitSetRoom::resize(rcl_wait_set_t & set) const
{
  return rcl_wait_set_resize(&set, subscriptions, guard_conditions, timers, clients, services, events);
}

WaitSet::WaitSet(const Context::SharedPtr & context)
: context_(context->get_rcl_context())
{
  check(
    rcl_wait_set_init(
      &set_, 0, 1, 0, 0, 0, 0, context_.get(), rcl_get_default_allocator()),
    "failed to create wait set");
}

WaitSet::~WaitSet()
{
  if (rcl_wait_set_fini(&set_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

bool WaitSet::wait(
  const std::vector<std::shared_ptr<Entity>> & entities, const GuardCondition & interrupt,
  std::chrono::nanoseconds timeout)
{
  fill(entities, interrupt);
  const rcl_ret_t ret = rcl_wait(&set_, timeout.count());
  if (ret == RCL_RET_TIMEOUT) {
    rcl_reset_error();
    return false;
  }
  check(ret, "rcl_wait() failed");
  return true;
}

bool WaitSet::is_ready(std::size_t index) const
{
  const auto & place = places_[index];
  switch (place.entity->kind()) {
    case EntityKind::timer:
      return set_.timers[place.index] != nullptr;
    case EntityKind::subscription:
      return set_.subscriptions[place.index] != nullptr;
    case EntityKind::service:
      return set_.services[place.index] != nullptr;
    case EntityKind::client:
      return set_.clients[place.index] != nullptr;
    case EntityKind::event:
      return set_.events[place.index] != nullptr;
    case EntityKind::waitable:
      return waitable_of(*place.entity).is_ready(set_);
    default:
      return set_.guard_conditions[place.index] != nullptr;
  }
}

void WaitSet::fill(
  const std::vector<std::shared_ptr<Entity>> & entities, const GuardCondition & interrupt)
{
  make_room(entities);
  check(
    rcl_wait_set_add_guard_condition(&set_, &interrupt.get_rcl_guard_condition(), nullptr),
    "failed to add a guard condition to the wait set");
  places_.resize(entities.size());
  for (std::size_t i = 0; i < entities.size(); ++i) {
    places_[i].entity = entities[i].get();
    entities[i]->before_wait();
    check(add_to_wait_set(set_, *entities[i], places_[i].index), "failed to add to the wait set");
  }
}

void WaitSet::make_room(const std::vector<std::shared_ptr<Entity>> & entities)
{
  WaitSetRoom room;
  room.guard_conditions = 1;  // the interrupt
  for (const auto & entity : entities) {
    room.add(*entity);
  }
  if (room.fits(set_)) {
    check(rcl_wait_set_clear(&set_), "failed to clear the wait set");
  } else {
    check(room.resize(set_), "failed to resize the wait set");
  }
}

}  // namespace rclcpp::detail
