#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "rcl/wait.h"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class Waitable;

namespace detail
{

/// A waitable, as executors and wait sets see it.
class WaitableEntity : public Entity
{
public:
  explicit WaitableEntity(Waitable & waitable) : waitable_(waitable) {}

  Waitable & waitable() const {return waitable_;}
  EntityKind kind() const noexcept override {return EntityKind::waitable;}
  const void * rcl_entity() const noexcept override {return nullptr;}
  void execute() override;

private:
  Waitable & waitable_;
};

/// Keeps the waitable alive.
std::shared_ptr<Entity> entity_of(const std::shared_ptr<Waitable> & waitable);

}  // namespace detail

/// Something of your own that an executor or a wait set waits for.
class Waitable
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Waitable)

  Waitable() : entity_(*this) {}
  virtual ~Waitable() = default;

  // How many things of each kind it adds to a wait set.
  virtual std::size_t get_number_of_ready_subscriptions() {return 0;}
  virtual std::size_t get_number_of_ready_timers() {return 0;}
  virtual std::size_t get_number_of_ready_clients() {return 0;}
  virtual std::size_t get_number_of_ready_events() {return 0;}
  virtual std::size_t get_number_of_ready_services() {return 0;}
  virtual std::size_t get_number_of_ready_guard_conditions() {return 0;}

  // Each of these three has two forms; a class overrides one of them. Those with a pointer are the older ones.
  virtual void add_to_wait_set(rcl_wait_set_t & wait_set);
  virtual bool is_ready(const rcl_wait_set_t & wait_set);
  virtual void execute(const std::shared_ptr<void> & data);
#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#endif
  virtual void add_to_wait_set(rcl_wait_set_t * wait_set);
  virtual bool is_ready(rcl_wait_set_t * wait_set);
  virtual void execute(std::shared_ptr<void> & data);
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

  /// Gives what `execute` gets.
  virtual std::shared_ptr<void> take_data() = 0;
  /// The same, for the part of it that its callback was called for. Throws std::runtime_error by default.
  virtual std::shared_ptr<void> take_data_by_entity_id(std::size_t id);

  /// Throws std::runtime_error by default.
  virtual void set_on_ready_callback(std::function<void(std::size_t, int)> callback);
  virtual void clear_on_ready_callback();

  bool exchange_in_use_by_wait_set_state(bool in_use_state)
  {
    return entity_.exchange_in_use_by_wait_set_state(in_use_state);
  }

private:
  friend std::shared_ptr<detail::Entity> detail::entity_of(const std::shared_ptr<Waitable> &);

  detail::WaitableEntity entity_;
};

}  // namespace rclcpp
