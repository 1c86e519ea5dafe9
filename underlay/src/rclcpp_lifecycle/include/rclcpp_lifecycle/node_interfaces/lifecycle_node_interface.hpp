#pragma once

#include <cstdint>

#include "lifecycle_msgs/msg/transition.hpp"
#include "rclcpp_lifecycle/state.hpp"

namespace rclcpp_lifecycle::node_interfaces
{

/// What a node does on its way from state to state. Each is called in the state between, and is given the one
/// before.
class LifecycleNodeInterface
{
public:
  enum class CallbackReturn : std::uint8_t
  {
    SUCCESS = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_SUCCESS,  ///< on to the next state
    FAILURE = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_FAILURE,  ///< back to the one before
    ERROR = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_ERROR       ///< on_error is called
  };

  virtual ~LifecycleNodeInterface() = default;

  virtual CallbackReturn on_configure(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_cleanup(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_shutdown(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_activate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_deactivate(const State &) {return CallbackReturn::SUCCESS;}
  /// With success the node can be configured again, else it is finalized.
  virtual CallbackReturn on_error(const State &) {return CallbackReturn::SUCCESS;}

protected:
  LifecycleNodeInterface() = default;
};

}  // namespace rclcpp_lifecycle::node_interfaces
