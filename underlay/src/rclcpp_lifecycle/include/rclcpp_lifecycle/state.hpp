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

  std::uint8_t id() const {return id_;}
  std::string label() const {return label_;}

private:
  std::uint8_t id_;
  std::string label_;
};

}  // namespace rclcpp_lifecycle
