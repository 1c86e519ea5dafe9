#include "rclcpp/timer.hpp"

#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

/// What a timer uses, in the order in which it must go.
struct Owned
{
  Clock::SharedPtr clock;
  std::shared_ptr<rcl_context_t> context;
  rcl_timer_t timer = rcl_get_zero_initialized_timer();

  Owned() = default;
  Owned(const Owned &) = delete;
  Owned & operator=(const Owned &) = delete;
  ~Owned()
  {
    const std::lock_guard lock(clock->get_clock_mutex());
    if (rcl_timer_fini(&timer) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }
};

}  // namespace

TimerBase::TimerBase(
  Clock::SharedPtr clock, std::chrono::nanoseconds period, Callback callback,
  Context::SharedPtr context, bool autostart)
: clock_(std::move(clock)), callback_(std::move(callback))
{
  context = context ? context : contexts::get_global_default_context();
  auto owned = std::make_shared<Owned>();
  owned->clock = clock_;
  owned->context = context->get_rcl_context();
  const std::lock_guard lock(clock_->get_clock_mutex());
  detail::check(
    rcl_timer_init2(
      &owned->timer, clock_->get_clock_handle(), owned->context.get(), period.count(), nullptr,
      rcl_get_default_allocator(), autostart),
    "Couldn't initialize rcl timer handle");
  handle_ = {owned, &owned->timer};
}

TimerBase::~TimerBase()
{
  try {
    clear_on_reset_callback();  // others may hold the handle for longer
  } catch (const std::exception &) {
    rcl_reset_error();
  }
}

void TimerBase::set_on_reset_callback(std::function<void(std::size_t)> callback)
{
  on_reset_.set(
    std::move(callback), [this](rcl_event_callback_t function, const void * data) {
      return rcl_timer_set_on_reset_callback(handle_.get(), function, data);
    }, "set_on_reset_callback");
}

void TimerBase::clear_on_reset_callback()
{
  on_reset_.clear(
    [this](rcl_event_callback_t function, const void * data) {
      return rcl_timer_set_on_reset_callback(handle_.get(), function, data);
    });
}

TimerInfo TimerBase::last_call() const
{
  const std::lock_guard lock(call_mutex_);
  const auto type = clock_->get_clock_type();
  return {Time(last_call_.expected_call_time, type), Time(last_call_.actual_call_time, type)};
}

void TimerBase::cancel()
{
  detail::check(rcl_timer_cancel(handle_.get()), "Couldn't cancel timer");
}

bool TimerBase::is_canceled()
{
  bool canceled = false;
  detail::check(
    rcl_timer_is_canceled(handle_.get(), &canceled), "Couldn't get timer cancelled state");
  return canceled;
}

void TimerBase::reset()
{
  detail::check(rcl_timer_reset(handle_.get()), "Couldn't reset timer");
}

bool TimerBase::begin_period()
{
  const std::lock_guard lock(call_mutex_);
  const rcl_ret_t ret = rcl_timer_call_with_info(handle_.get(), &last_call_);
  if (ret == RCL_RET_TIMER_CANCELED) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "Failed to call timer");
  return true;
}

std::shared_ptr<void> TimerBase::call()
{
  if (!begin_period()) {
    return nullptr;
  }
  const std::lock_guard lock(call_mutex_);
  return std::make_shared<rcl_timer_call_info_t>(last_call_);
}

void TimerBase::execute_callback(const std::shared_ptr<void> & data)
{
  if (data) {
    const std::lock_guard lock(call_mutex_);
    last_call_ = *std::static_pointer_cast<rcl_timer_call_info_t>(data);
  }
  callback_(*this);
}

std::shared_ptr<const rcl_timer_t> TimerBase::get_timer_handle()
{
  return handle_;
}

std::chrono::nanoseconds TimerBase::time_until_trigger()
{
  std::int64_t left = 0;
  const rcl_ret_t ret = rcl_timer_get_time_until_next_call(handle_.get(), &left);
  if (ret == RCL_RET_TIMER_CANCELED) {
    rcl_reset_error();
    return std::chrono::nanoseconds::max();
  }
  detail::check(ret, "Timer could not get time until next call");
  return std::chrono::nanoseconds(left);
}

bool TimerBase::is_steady()
{
  return clock_->get_clock_type() == RCL_STEADY_TIME;
}

bool TimerBase::is_ready()
{
  bool ready = false;
  detail::check(rcl_timer_is_ready(handle_.get(), &ready), "Failed to check timer");
  return ready;
}

}  // namespace rclcpp
