#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace rclcpp::detail
{

/// Seconds, rounded down, and what is left of them, as messages hold both.
struct TimeParts
{
  std::int32_t seconds;
  std::uint32_t nanoseconds;
};

inline TimeParts split(std::int64_t nanoseconds)
{
  constexpr std::int64_t second = 1000000000;
  std::int64_t seconds = nanoseconds / second;
  std::int64_t rest = nanoseconds % second;
  if (rest < 0) {
    rest += second;
    --seconds;
  }
  constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (seconds < least) {
    return {static_cast<std::int32_t>(least), 0};
  }
  if (seconds > most) {
    return {static_cast<std::int32_t>(most), std::numeric_limits<std::uint32_t>::max()};
  }
  return {static_cast<std::int32_t>(seconds), static_cast<std::uint32_t>(rest)};
}

/// Whether two steps down led to the lowest number, which counts as an underflow: its negative does not fit.
inline bool is_too_low(std::int64_t result, std::int64_t left, std::int64_t right)
{
  return result == std::numeric_limits<std::int64_t>::min() && left < 0 && right != 0;
}

inline std::int64_t sum(std::int64_t left, std::int64_t right)
{
  std::int64_t result = 0;
  if (!__builtin_add_overflow(left, right, &result) && !is_too_low(result, left, right)) {
    return result;
  }
  if (right > 0) {
    throw std::overflow_error("addition leads to int64_t overflow");
  }
  throw std::underflow_error("addition leads to int64_t underflow");
}

inline std::int64_t difference(std::int64_t left, std::int64_t right, const std::string & of)
{
  std::int64_t result = 0;
  if (!__builtin_sub_overflow(left, right, &result) && !is_too_low(result, left, right)) {
    return result;
  }
  if (right < 0) {
    throw std::overflow_error(of + " subtraction leads to int64_t overflow");
  }
  throw std::underflow_error(of + " subtraction leads to int64_t underflow");
}

}  // namespace rclcpp::detail
