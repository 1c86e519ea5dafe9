#include "rclcpp_lifecycle/state.hpp"

#include <stdexcept>

#include "lifecycle_msgs/msg/state.hpp"

namespace rclcpp_lifecycle
{

namespace
{

const rcl_lifecycle_state_t & present(const rcl_lifecycle_state_t * state)
{
  if (!state) {
    throw std::runtime_error("rcl_lifecycle_state_handle is null");
  }
  return *state;
}

}  // namespace

State::State()
: State(lifecycle_msgs::msg::State::PRIMARY_STATE_UNKNOWN, "unknown")
{
}

State::State(std::uint8_t id, const std::string & label)
: id_(id), label_(label)
{
  if (label.empty()) {
    throw std::runtime_error("Lifecycle State cannot have an empty label.");
  }
}

State::State(const rcl_lifecycle_state_t * rcl_lifecycle_state_handle)
: State(present(rcl_lifecycle_state_handle).id, present(rcl_lifecycle_state_handle).label)
{
}

std::uint8_t State::id() const
{
  label();
  return id_;
}

std::string State::label() const
{
  if (label_.empty()) {
    throw std::runtime_error("Error in state! Internal state_handle is NULL.");
  }
  return label_;
}

void State::reset() noexcept
{
  label_.clear();
}

}  // namespace rclcpp_lifecycle
