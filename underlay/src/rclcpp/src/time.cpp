#include "rclcpp/time.hpp"

#include <chrono>
#include <stdexcept>

#include "time_parts.hpp"

namespace rclcpp
{

namespace
{

rcl_time_point_t point(std::int64_t nanoseconds, rcl_clock_type_t clock_type)
{
  if (nanoseconds < 0) {
    throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
  }
  rcl_time_point_t result;
  result.nanoseconds = nanoseconds;
  result.clock_type = clock_type;
  return result;
}

void same_clock(const Time & left, const Time & right, const char * verb)
{
  if (left.get_clock_type() != right.get_clock_type()) {
    throw std::runtime_error(std::string("can't ") + verb + " times with different time sources");
  }
}

}  // namespace

Time::Time(std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t clock_type)
: time_(point(RCL_S_TO_NS(static_cast<std::int64_t>(seconds)) + nanoseconds, clock_type))
{
}

Time::Time(std::int64_t nanoseconds, rcl_clock_type_t clock_type)
{
  time_.nanoseconds = nanoseconds;
  time_.clock_type = clock_type;
}

Time::Time(const builtin_interfaces::msg::Time & time_msg, rcl_clock_type_t clock_type)
: Time(time_msg.sec, time_msg.nanosec, clock_type)
{
}

Time::Time(const rcl_time_point_t & time_point)
: time_(time_point)
{
}

Time::operator builtin_interfaces::msg::Time() const
{
  return convert_rcl_time_to_sec_nanos(time_.nanoseconds);
}

Time & Time::operator=(const builtin_interfaces::msg::Time & time_msg)
{
  return *this = Time(time_msg);
}

bool Time::operator==(const Time & rhs) const
{
  same_clock(*this, rhs, "compare");
  return time_.nanoseconds == rhs.time_.nanoseconds;
}

bool Time::operator!=(const Time & rhs) const
{
  return !(*this == rhs);
}

bool Time::operator<(const Time & rhs) const
{
  same_clock(*this, rhs, "compare");
  return time_.nanoseconds < rhs.time_.nanoseconds;
}

bool Time::operator<=(const Time & rhs) const
{
  return !(rhs < *this);
}

bool Time::operator>=(const Time & rhs) const
{
  return !(*this < rhs);
}

bool Time::operator>(const Time & rhs) const
{
  return rhs < *this;
}

Time Time::operator+(const Duration & rhs) const
{
  return Time(detail::sum(time_.nanoseconds, rhs.nanoseconds()), time_.clock_type);
}

Duration Time::operator-(const Time & rhs) const
{
  same_clock(*this, rhs, "subtract");
  return Duration::from_nanoseconds(
    detail::difference(time_.nanoseconds, rhs.time_.nanoseconds, "time"));
}

Time Time::operator-(const Duration & rhs) const
{
  return Time(detail::difference(time_.nanoseconds, rhs.nanoseconds(), "time"), time_.clock_type);
}

Time & Time::operator+=(const Duration & rhs)
{
  return *this = *this + rhs;
}

Time & Time::operator-=(const Duration & rhs)
{
  return *this = *this - rhs;
}

double Time::seconds() const
{
  return std::chrono::duration<double>(std::chrono::nanoseconds(time_.nanoseconds)).count();
}

Time Time::max(rcl_clock_type_t clock_type)
{
  return Time(std::numeric_limits<std::int32_t>::max(), 999999999, clock_type);
}

Time operator+(const Duration & lhs, const Time & rhs)
{
  return rhs + lhs;
}

builtin_interfaces::msg::Time convert_rcl_time_to_sec_nanos(rcl_time_point_value_t time_point)
{
  const auto parts = detail::split(time_point);
  builtin_interfaces::msg::Time message;
  message.sec = parts.seconds;
  message.nanosec = parts.nanoseconds;
  return message;
}

}  // namespace rclcpp
