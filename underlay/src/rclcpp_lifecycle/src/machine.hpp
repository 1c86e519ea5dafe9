#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_available_states.hpp"
#include "lifecycle_msgs/srv/get_available_transitions.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rcl_lifecycle/rcl_lifecycle.h"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace rclcpp_lifecycle
{

/// The states of a node, with rcl's table of what leads where, and how others see and change them.
class LifecycleNode::Machine
{
public:
  Machine(rclcpp::Node & node, bool enable_communication_interface);
  Machine(const Machine &) = delete;
  Machine & operator=(const Machine &) = delete;
  ~Machine();

  /// `state` is the one between, in which it is called.
  void set_callback(std::uint8_t state, Callback callback);
  void add(std::weak_ptr<ManagedEntityInterface> entity);
  void for_each_entity(void (ManagedEntityInterface::* method)());

  const State & current() const {return current_;}
  std::vector<State> states() const;
  std::vector<Transition> from_here() const;
  std::vector<Transition> transitions() const;

  /// What the callback gives back; ERROR where the transition does not begin, or does not end.
  CallbackReturn change(std::uint8_t transition_id);
  CallbackReturn change(const char * label);

private:
  using ChangeState = lifecycle_msgs::srv::ChangeState;
  using GetState = lifecycle_msgs::srv::GetState;
  using GetStates = lifecycle_msgs::srv::GetAvailableStates;
  using GetTransitions = lifecycle_msgs::srv::GetAvailableTransitions;

  void communicate();
  void answer(ChangeState::Request & request, ChangeState::Response & response);
  CallbackReturn call_back(const State & before);
  bool begin(std::uint8_t transition_id);
  bool end(const char * label);

  rclcpp::Node & node_;
  mutable std::recursive_mutex mutex_;
  rcl_lifecycle_state_machine_t machine_ = rcl_lifecycle_get_zero_initialized_state_machine();
  State current_;
  std::map<std::uint8_t, Callback> callbacks_;
  std::vector<std::weak_ptr<ManagedEntityInterface>> entities_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace rclcpp_lifecycle
