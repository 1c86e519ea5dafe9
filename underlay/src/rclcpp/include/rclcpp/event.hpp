#pragma once

#include <atomic>

#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// Something that has happened, or not yet.
class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Event)

  Event() = default;
  /// These give what was before.
  bool set() {return state_.exchange(true);}
  bool check_and_clear() {return state_.exchange(false);}
  bool check() const {return state_;}

private:
  std::atomic_bool state_{false};
};

}  // namespace rclcpp
