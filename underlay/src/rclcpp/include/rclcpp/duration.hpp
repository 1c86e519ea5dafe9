#pragma once

#include <chrono>
#include <cstdint>

#include "builtin_interfaces/msg/detail/duration__struct.hpp"
#include "builtin_interfaces/msg/detail/time__struct.hpp"
#include "rcl/time.h"
#include "rmw/types.h"

namespace rclcpp
{

/// A length of time in nanoseconds; it may be negative.
class Duration
{
public:
  Duration() = default;
  Duration(std::int32_t seconds, std::uint32_t nanoseconds);
  // NOLINTNEXTLINE: a duration of <chrono> may stand wherever one of ours is asked for
  Duration(std::chrono::nanoseconds nanoseconds) : nanoseconds_(nanoseconds.count()) {}
  template<typename Rep, typename Period>
  // NOLINTNEXTLINE: as above
  Duration(const std::chrono::duration<Rep, Period> & duration)
  : Duration(std::chrono::duration_cast<std::chrono::nanoseconds>(duration)) {}
  Duration(const builtin_interfaces::msg::Duration & duration_msg);  // NOLINT: messages convert
  explicit Duration(const rcl_duration_t & duration) : nanoseconds_(duration.nanoseconds) {}
  Duration(const Duration & rhs) = default;
  virtual ~Duration() = default;

  operator builtin_interfaces::msg::Duration() const;  // NOLINT: messages convert
  Duration & operator=(const Duration & rhs) = default;
  Duration & operator=(const builtin_interfaces::msg::Duration & duration_msg);

  bool operator==(const Duration & rhs) const {return nanoseconds_ == rhs.nanoseconds_;}
  bool operator!=(const Duration & rhs) const {return nanoseconds_ != rhs.nanoseconds_;}
  bool operator<(const Duration & rhs) const {return nanoseconds_ < rhs.nanoseconds_;}
  bool operator<=(const Duration & rhs) const {return nanoseconds_ <= rhs.nanoseconds_;}
  bool operator>=(const Duration & rhs) const {return nanoseconds_ >= rhs.nanoseconds_;}
  bool operator>(const Duration & rhs) const {return nanoseconds_ > rhs.nanoseconds_;}

  // These throw std::overflow_error and std::underflow_error.
  Duration operator+(const Duration & rhs) const;
  Duration & operator+=(const Duration & rhs);
  Duration operator-(const Duration & rhs) const;
  Duration & operator-=(const Duration & rhs);
  Duration operator*(double scale) const;
  Duration & operator*=(double scale);

  static Duration max();
  std::int64_t nanoseconds() const {return nanoseconds_;}
  double seconds() const;

  static Duration from_seconds(double seconds);
  static Duration from_nanoseconds(std::int64_t nanoseconds);
  static Duration from_rmw_time(rmw_time_t duration);

  template<class DurationT>
  DurationT to_chrono() const
  {
    return std::chrono::duration_cast<DurationT>(std::chrono::nanoseconds(nanoseconds_));
  }

  /// Throws std::runtime_error when it is negative.
  rmw_time_t to_rmw_time() const;

private:
  std::int64_t nanoseconds_ = 0;
};

// Of a message. These throw std::runtime_error for a negative time, std::overflow_error, std::underflow_error.
builtin_interfaces::msg::Time operator+(const builtin_interfaces::msg::Time & lhs, const Duration & rhs);
builtin_interfaces::msg::Time operator-(const builtin_interfaces::msg::Time & lhs, const Duration & rhs);

}  // namespace rclcpp
