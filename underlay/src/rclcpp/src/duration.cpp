#include "rclcpp/duration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rcl/time.h"
#include "rclcpp/time.hpp"
#include "time_parts.hpp"

namespace rclcpp
{

Duration::Duration(std::int32_t seconds, std::uint32_t nanoseconds)
: nanoseconds_(RCL_S_TO_NS(static_cast<std::int64_t>(seconds)) + nanoseconds)
{
}

Duration::Duration(const builtin_interfaces::msg::Duration & duration_msg)
: Duration(duration_msg.sec, duration_msg.nanosec)
{
}

Duration::operator builtin_interfaces::msg::Duration() const
{
  const auto parts = detail::split(nanoseconds_);
  builtin_interfaces::msg::Duration message;
  message.sec = parts.seconds;
  message.nanosec = parts.nanoseconds;
  return message;
}

Duration & Duration::operator=(const builtin_interfaces::msg::Duration & duration_msg)
{
  return *this = Duration(duration_msg);
}

Duration Duration::operator+(const Duration & rhs) const
{
  return from_nanoseconds(detail::sum(nanoseconds_, rhs.nanoseconds_));
}

Duration & Duration::operator+=(const Duration & rhs)
{
  return *this = *this + rhs;
}

Duration Duration::operator-(const Duration & rhs) const
{
  return from_nanoseconds(detail::difference(nanoseconds_, rhs.nanoseconds_, "duration"));
}

Duration & Duration::operator-=(const Duration & rhs)
{
  return *this = *this - rhs;
}

Duration Duration::operator*(double scale) const
{
  if (!std::isfinite(scale)) {
    throw std::runtime_error("abnormal scale in rclcpp::Duration");
  }
  const long double scaled = static_cast<long double>(nanoseconds_) * static_cast<long double>(scale);
  constexpr auto limit = static_cast<long double>(std::numeric_limits<std::int64_t>::max());
  if (scaled > limit) {
    throw std::overflow_error("duration scaling leads to int64_t overflow");
  }
  if (scaled < -limit) {
    throw std::underflow_error("duration scaling leads to int64_t underflow");
  }
  return from_nanoseconds(static_cast<std::int64_t>(scaled));
}

Duration & Duration::operator*=(double scale)
{
  return *this = *this * scale;
}

Duration Duration::max()
{
  return Duration(std::numeric_limits<std::int32_t>::max(), 999999999);
}

double Duration::seconds() const
{
  return std::chrono::duration<double>(std::chrono::nanoseconds(nanoseconds_)).count();
}

Duration Duration::from_seconds(double seconds)
{
  return from_nanoseconds(static_cast<std::int64_t>(RCL_S_TO_NS(seconds)));
}

Duration Duration::from_nanoseconds(std::int64_t nanoseconds)
{
  return Duration(std::chrono::nanoseconds(nanoseconds));
}

Duration Duration::from_rmw_time(rmw_time_t duration)
{
  constexpr std::uint64_t limit = std::numeric_limits<std::int64_t>::max();
  constexpr std::uint64_t second = 1000000000;
  const bool is_too_long = duration.sec > limit / second || duration.nsec > limit;
  const std::uint64_t all = is_too_long ? limit : duration.sec * second + duration.nsec;
  return from_nanoseconds(static_cast<std::int64_t>(std::min(all, limit)));
}

rmw_time_t Duration::to_rmw_time() const
{
  if (nanoseconds_ < 0) {
    throw std::runtime_error("rmw_time_t cannot be negative");
  }
  const auto all = static_cast<std::uint64_t>(nanoseconds_);
  return {all / 1000000000u, all % 1000000000u};
}

namespace
{

std::int64_t nanoseconds_of(const builtin_interfaces::msg::Time & time)
{
  if (time.sec < 0) {
    throw std::runtime_error("message time is negative");
  }
  return RCL_S_TO_NS(static_cast<std::int64_t>(time.sec)) + time.nanosec;
}

}  // namespace

builtin_interfaces::msg::Time operator+(const builtin_interfaces::msg::Time & lhs, const Duration & rhs)
{
  return convert_rcl_time_to_sec_nanos(detail::sum(nanoseconds_of(lhs), rhs.nanoseconds()));
}

builtin_interfaces::msg::Time operator-(const builtin_interfaces::msg::Time & lhs, const Duration & rhs)
{
  return convert_rcl_time_to_sec_nanos(detail::difference(nanoseconds_of(lhs), rhs.nanoseconds(), "time"));
}

}  // namespace rclcpp
