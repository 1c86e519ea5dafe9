#pragma once

#include <cstdint>
#include <string>

#include "rcl_lifecycle/data_types.h"

namespace rclcpp_lifecycle
{

/// A state of a node: its number and its name.
class State
{
public:
  /// The unknown one.
  State();
  /// Throws std::runtime_error for an empty label.
  State(std::uint8_t id, const std::string & label);
  /// Throws std::runtime_error for a null pointer.
  explicit State(const rcl_lifecycle_state_t * rcl_lifecycle_state_handle);
  State(const State &) = default;
  State & operator=(const State &) = default;
  virtual ~State() = default;

  // These throw std::runtime_error after reset().
  std::uint8_t id() const;
  std::string label() const;

protected:
  void reset() noexcept;

private:
  std::uint8_t id_;
  std::string label_;  // empty after reset()
};

}  // namespace rclcpp_lifecycle
