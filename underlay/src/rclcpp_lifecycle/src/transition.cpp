#include "rclcpp_lifecycle/transition.hpp"

#include <stdexcept>
#include <utility>

namespace rclcpp_lifecycle
{

namespace
{

const rcl_lifecycle_transition_t & present(const rcl_lifecycle_transition_t * transition)
{
  if (!transition) {
    throw std::runtime_error("rcl_lifecycle_transition_handle is null");
  }
  return *transition;
}

const State & present(const std::optional<State> & state)
{
  if (!state) {
    throw std::runtime_error("rcl_lifecycle_state_handle is null");
  }
  return *state;
}

}  // namespace

Transition::Transition(std::uint8_t id, const std::string & label)
: id_(id), label_(label)
{
}

Transition::Transition(std::uint8_t id, const std::string & label, State && start, State && goal)
: id_(id), label_(label), start_(std::move(start)), goal_(std::move(goal))
{
}

Transition::Transition(const rcl_lifecycle_transition_t * rcl_lifecycle_transition_handle)
: Transition(
    static_cast<std::uint8_t>(present(rcl_lifecycle_transition_handle).id),
    rcl_lifecycle_transition_handle->label, State(rcl_lifecycle_transition_handle->start),
    State(rcl_lifecycle_transition_handle->goal))
{
}

State Transition::start_state() const
{
  return present(start_);
}

State Transition::goal_state() const
{
  return present(goal_);
}

}  // namespace rclcpp_lifecycle
