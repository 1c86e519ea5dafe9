#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rcl/timer.h"
#include "rclcpp/clock.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/detail/event_callback.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{

/// When a timer was due, and when it was called.
struct TimerInfo
{
  Time expected_call_time;
  Time actual_call_time;
};

/// Calls back once in each period, as long as somebody holds it.
class TimerBase : public detail::Entity, public std::enable_shared_from_this<TimerBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(TimerBase)
  using Callback = std::function<void(TimerBase &)>;

  TimerBase(
    Clock::SharedPtr clock, std::chrono::nanoseconds period, Callback callback,
    Context::SharedPtr context = nullptr, bool autostart = true);
  ~TimerBase() override;

  /// Stops it until it is reset.
  void cancel();
  bool is_canceled();
  void reset();

  /// Called when the timer was reset.
  void set_on_reset_callback(std::function<void(std::size_t)> callback);
  void clear_on_reset_callback();

  /// When the last period began, and when it was due to.
  TimerInfo last_call() const;

  /// Begins a period, and returns the data for `execute_callback`. Empty if the timer was canceled.
  std::shared_ptr<void> call();
  void execute_callback(const std::shared_ptr<void> & data);
  std::shared_ptr<const rcl_timer_t> get_timer_handle();

  /// Of a cancelled one: std::chrono::nanoseconds::max().
  std::chrono::nanoseconds time_until_trigger();
  bool is_steady();
  bool is_ready();
  Clock::SharedPtr get_clock() {return clock_;}

  detail::EntityKind kind() const noexcept override {return detail::EntityKind::timer;}
  const void * rcl_entity() const noexcept override {return handle_.get();}
  bool claim() override {return begin_period();}
  void execute() override {callback_(*this);}

private:
  bool begin_period();

  Clock::SharedPtr clock_;
  std::shared_ptr<rcl_timer_t> handle_;
  Callback callback_;
  mutable std::mutex call_mutex_;
  rcl_timer_call_info_t last_call_{};
  detail::EventCallback on_reset_;
};

using VoidCallbackType = std::function<void()>;
using TimerCallbackType = std::function<void(TimerBase &)>;
using TimerInfoCallbackType = std::function<void(const TimerInfo &)>;

namespace detail
{

/// The period in nanoseconds. Throws std::invalid_argument when it is negative or too long.
template<typename Rep, typename Period>
std::chrono::nanoseconds timer_period(std::chrono::duration<Rep, Period> period)
{
  if (period < std::chrono::duration<Rep, Period>::zero()) {
    throw std::invalid_argument("timer period cannot be negative");
  }
  using Wide = std::chrono::duration<long double, std::nano>;
  if (std::chrono::duration_cast<Wide>(period) > Wide(std::chrono::nanoseconds::max())) {
    throw std::invalid_argument("timer period must be less than std::chrono::nanoseconds::max()");
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(period);
}

template<typename CallbackT>
TimerBase::Callback timer_callback(CallbackT && callback)
{
  using Given = std::decay_t<CallbackT>;
  if constexpr (std::is_invocable_v<Given &, TimerBase &>) {
    return std::forward<CallbackT>(callback);
  } else if constexpr (std::is_invocable_v<Given &, const TimerInfo &>) {
    return [callback = Given(std::forward<CallbackT>(callback))](TimerBase & timer) mutable {
             callback(timer.last_call());
           };
  } else {
    static_assert(
      std::is_invocable_v<Given &>,
      "a timer's callback takes nothing, rclcpp::TimerBase &, or const rclcpp::TimerInfo &");
    return [callback = Given(std::forward<CallbackT>(callback))](TimerBase &) mutable {callback();};
  }
}

}  // namespace detail

/// A timer that follows any clock. Nothing calls back until it is added to a node or a wait set.
template<typename FunctorT = TimerBase::Callback>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)

  GenericTimer(
    Clock::SharedPtr clock, std::chrono::nanoseconds period, FunctorT callback,
    Context::SharedPtr context = nullptr, bool autostart = true)
  : TimerBase(
      std::move(clock), period, detail::timer_callback(std::move(callback)), std::move(context), autostart)
  {
  }
};

/// A timer of real time.
template<typename FunctorT = TimerBase::Callback>
class WallTimer : public GenericTimer<FunctorT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)

  WallTimer(
    std::chrono::nanoseconds period, FunctorT callback, Context::SharedPtr context = nullptr,
    bool autostart = true)
  : GenericTimer<FunctorT>(
      std::make_shared<Clock>(RCL_STEADY_TIME), period, std::move(callback), std::move(context), autostart)
  {
  }
};

}  // namespace rclcpp
