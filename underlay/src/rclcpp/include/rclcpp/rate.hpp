#pragma once

#include <chrono>
#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{

class RateBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(RateBase)
  virtual ~RateBase() = default;
  virtual bool sleep() = 0;
  virtual bool is_steady() const = 0;
  virtual rcl_clock_type_t get_type() const = 0;
  virtual void reset() = 0;
};

/// Keeps a loop to its rate: each sleep lasts until the next period begins.
class Rate : public RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)

  /// `rate` in Hz. Throws std::invalid_argument unless it, or the period, is positive.
  explicit Rate(double rate, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));
  explicit Rate(
    const Duration & period, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));

  /// False, and at once, when the period is over already.
  bool sleep() override;
  bool is_steady() const override {return get_type() == RCL_STEADY_TIME;}
  rcl_clock_type_t get_type() const override;
  void reset() override;
  std::chrono::nanoseconds period() const;

private:
  Clock::SharedPtr clock_;
  Duration period_;
  Time last_interval_;
};

class WallRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallRate)
  explicit WallRate(double rate);
  explicit WallRate(const Duration & period);
};

/// By a clock of <chrono>.
template<class ClockT = std::chrono::high_resolution_clock>
class GenericRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericRate)
  explicit GenericRate(double rate) : Rate(rate, clock()) {}
  explicit GenericRate(std::chrono::nanoseconds period) : Rate(Duration(period), clock()) {}

private:
  static Clock::SharedPtr clock()
  {
    return std::make_shared<Clock>(ClockT::is_steady ? RCL_STEADY_TIME : RCL_SYSTEM_TIME);
  }
};

class ROSRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ROSRate)
  explicit ROSRate(double rate);
  explicit ROSRate(const Duration & period);
};

}  // namespace rclcpp
