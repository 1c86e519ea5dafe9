#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rcl_lifecycle/data_types.h"
#include "rclcpp_lifecycle/state.hpp"

namespace rclcpp_lifecycle
{

/// The way from a state to another one.
class Transition
{
public:
  Transition() = delete;
  explicit Transition(std::uint8_t id, const std::string & label = "");
  Transition(std::uint8_t id, const std::string & label, State && start, State && goal);
  /// Throws std::runtime_error for a null pointer.
  explicit Transition(const rcl_lifecycle_transition_t * rcl_lifecycle_transition_handle);
  Transition(const Transition &) = default;
  Transition & operator=(const Transition &) = default;
  virtual ~Transition() = default;

  std::uint8_t id() const {return id_;}
  std::string label() const {return label_;}
  /// Throw std::runtime_error for a transition that was made without them.
  State start_state() const;
  State goal_state() const;

private:
  std::uint8_t id_;
  std::string label_;
  std::optional<State> start_, goal_;
};

}  // namespace rclcpp_lifecycle
