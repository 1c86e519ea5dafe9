#pragma once

#include <cstdint>

#include "builtin_interfaces/msg/detail/time__struct.hpp"
#include "rcl/time.h"
#include "rclcpp/duration.hpp"

namespace rclcpp
{

/// A point in time of one kind of clock. Those of different clocks cannot be compared: std::runtime_error.
class Time
{
public:
  Time(std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  explicit Time(std::int64_t nanoseconds = 0, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  Time(
    const builtin_interfaces::msg::Time & time_msg,  // NOLINT: messages convert
    rcl_clock_type_t clock_type = RCL_ROS_TIME);
  explicit Time(const rcl_time_point_t & time_point);
  Time(const Time & rhs) = default;
  virtual ~Time() = default;

  operator builtin_interfaces::msg::Time() const;  // NOLINT: messages convert
  Time & operator=(const Time & rhs) = default;
  Time & operator=(const builtin_interfaces::msg::Time & time_msg);

  bool operator==(const Time & rhs) const;
  bool operator!=(const Time & rhs) const;
  bool operator<(const Time & rhs) const;
  bool operator<=(const Time & rhs) const;
  bool operator>=(const Time & rhs) const;
  bool operator>(const Time & rhs) const;

  // These throw std::overflow_error and std::underflow_error.
  Time operator+(const Duration & rhs) const;
  Duration operator-(const Time & rhs) const;
  Time operator-(const Duration & rhs) const;
  Time & operator+=(const Duration & rhs);
  Time & operator-=(const Duration & rhs);

  std::int64_t nanoseconds() const {return time_.nanoseconds;}
  static Time max(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  double seconds() const;
  rcl_clock_type_t get_clock_type() const {return time_.clock_type;}

private:
  rcl_time_point_t time_;
};

Time operator+(const Duration & lhs, const Time & rhs);
builtin_interfaces::msg::Time convert_rcl_time_to_sec_nanos(rcl_time_point_value_t time_point);

}  // namespace rclcpp
