#include "rclcpp/clock.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

// A clock that follows /clock is looked at this often by those who wait for a time of it.
constexpr std::chrono::milliseconds tick{1};

void require_valid(const Context::SharedPtr & context)
{
  if (!context || !context->is_valid()) {
    throw std::runtime_error("context cannot be slept with because it's invalid");
  }
}

}  // namespace

JumpHandler::JumpHandler(
  pre_callback_t pre_callback, post_callback_t post_callback, const rcl_jump_threshold_t & threshold)
: pre_callback(std::move(pre_callback)), post_callback(std::move(post_callback)),
  notice_threshold(threshold)
{
}

struct Clock::Impl
{
  explicit Impl(rcl_clock_type_t clock_type)
  : allocator(rcl_get_default_allocator())
  {
    detail::check(rcl_clock_init(clock_type, &clock, &allocator), "failed to initialize rcl clock");
  }
  Impl(const Impl &) = delete;
  Impl & operator=(const Impl &) = delete;
  ~Impl()
  {
    if (rcl_clock_fini(&clock) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

  static void on_jump(const rcl_time_jump_t * jump, bool before, void * data)
  {
    const auto & handler = *static_cast<const JumpHandler *>(data);
    if (before && handler.pre_callback) {
      handler.pre_callback();
    } else if (!before && handler.post_callback) {
      handler.post_callback(*jump);
    }
  }

  rcl_clock_t clock;
  rcl_allocator_t allocator;
  std::mutex mutex;

  /// Whether the context is still valid.
  bool sleep(const Context::SharedPtr & context, std::chrono::nanoseconds time)
  {
    {
      const std::lock_guard lock(sleepers_mutex);
      sleepers.push_back(context);
    }
    const bool alive = context->sleep_unless(time, stop);
    const std::lock_guard lock(sleepers_mutex);
    sleepers.erase(std::find(sleepers.begin(), sleepers.end(), context));
    return alive;
  }

  void wake()
  {
    const std::lock_guard lock(sleepers_mutex);
    stop = true;
    for (const auto & context : sleepers) {
      context->wake_sleepers();
    }
  }

  std::atomic_bool stop{false};
  std::mutex sleepers_mutex;
  std::vector<Context::SharedPtr> sleepers;  // one for each sleep
};

Clock::Clock(rcl_clock_type_t clock_type)
: impl_(std::make_shared<Impl>(clock_type))
{
}

Time Clock::now() const
{
  rcl_time_point_value_t nanoseconds = 0;
  detail::check(rcl_clock_get_now(&impl_->clock, &nanoseconds), "could not get current time stamp");
  return Time(nanoseconds, impl_->clock.type);
}

bool Clock::sleep_until(Time until, Context::SharedPtr context)
{
  require_valid(context);
  if (until.get_clock_type() != get_clock_type()) {
    throw std::runtime_error("until's clock type does not match this clock's type");
  }
  const bool simulated = get_clock_type() == RCL_ROS_TIME && ros_time_is_active();
  for (auto left = until - now(); left > Duration(0, 0); left = until - now()) {
    const auto rest = left.to_chrono<std::chrono::nanoseconds>();
    const bool alive = impl_->sleep(context, simulated ? tick : rest);
    const bool switched =
      get_clock_type() == RCL_ROS_TIME && simulated != ros_time_is_active();
    if (!alive || switched || impl_->stop.exchange(false)) {
      return false;
    }
  }
  return true;
}

void Clock::cancel_sleep_or_wait()
{
  impl_->wake();
}

bool Clock::sleep_for(Duration rel_time, Context::SharedPtr context)
{
  return sleep_until(now() + rel_time, std::move(context));
}

bool Clock::started()
{
  return now().nanoseconds() != 0;
}

bool Clock::wait_until_started(Context::SharedPtr context)
{
  return wait_until_started(Duration(std::chrono::hours(24 * 365 * 100)), std::move(context));
}

bool Clock::wait_until_started(
  const Duration & timeout, Context::SharedPtr context, const Duration & wait_tick_ns)
{
  require_valid(context);
  Clock steady(RCL_STEADY_TIME);
  const Time until = steady.now() + timeout;
  while (!started() && context->is_valid() && steady.now() < until) {
    context->sleep_for(wait_tick_ns.to_chrono<std::chrono::nanoseconds>());
  }
  return started();
}

bool Clock::ros_time_is_active()
{
  const std::lock_guard lock(impl_->mutex);
  bool active = false;
  detail::check(
    rcl_is_enabled_ros_time_override(&impl_->clock, &active), "failed to check ros_time_override_status");
  return active;
}

rcl_clock_t * Clock::get_clock_handle() noexcept
{
  return &impl_->clock;
}

rcl_clock_type_t Clock::get_clock_type() const noexcept
{
  return impl_->clock.type;
}

std::mutex & Clock::get_clock_mutex() noexcept
{
  return impl_->mutex;
}

JumpHandler::SharedPtr Clock::create_jump_callback(
  JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
  const rcl_jump_threshold_t & threshold)
{
  auto handler =
    std::make_unique<JumpHandler>(std::move(pre_callback), std::move(post_callback), threshold);
  const std::lock_guard lock(impl_->mutex);
  detail::check(
    rcl_clock_add_jump_callback(&impl_->clock, threshold, Impl::on_jump, handler.get()),
    "failed to add time jump callback");
  return {handler.release(), [impl = impl_](JumpHandler * gone) {
      const std::unique_ptr<JumpHandler> owner(gone);
      const std::lock_guard guard(impl->mutex);
      if (rcl_clock_remove_jump_callback(&impl->clock, Impl::on_jump, gone) != RCL_RET_OK) {
        rcl_reset_error();
      }
    }};
}

}  // namespace rclcpp
