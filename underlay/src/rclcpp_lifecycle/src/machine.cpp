#include "machine.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "lifecycle_msgs/msg/transition_event.h"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp_lifecycle
{

namespace
{

lifecycle_msgs::msg::State message_of(const State & state)
{
  lifecycle_msgs::msg::State message;
  message.id = state.id();
  message.label = state.label();
  return message;
}

lifecycle_msgs::msg::TransitionDescription message_of(const Transition & transition)
{
  lifecycle_msgs::msg::TransitionDescription message;
  message.transition.id = transition.id();
  message.transition.label = transition.label();
  message.start_state = message_of(transition.start_state());
  message.goal_state = message_of(transition.goal_state());
  return message;
}

template<typename MadeT, typename GivenT>
std::vector<MadeT> made_of(const GivenT * first, std::size_t size)
{
  std::vector<MadeT> made;
  for (std::size_t i = 0; i < size; ++i) {
    made.emplace_back(first + i);
  }
  return made;
}

template<typename MessageT, typename GivenT>
std::vector<MessageT> messages_of(const std::vector<GivenT> & given)
{
  std::vector<MessageT> messages;
  for (const auto & one : given) {
    messages.push_back(message_of(one));
  }
  return messages;
}

/// By which rcl knows the end of a transition.
const char * label_of(node_interfaces::LifecycleNodeInterface::CallbackReturn code)
{
  using Code = node_interfaces::LifecycleNodeInterface::CallbackReturn;
  return code == Code::SUCCESS ? rcl_lifecycle_transition_success_label :
         code == Code::FAILURE ? rcl_lifecycle_transition_failure_label :
         rcl_lifecycle_transition_error_label;
}

/// What rcl said, which is then forgotten.
std::string last_error()
{
  const std::string text = rcl_get_error_string().str;
  rcl_reset_error();
  return text;
}

}  // namespace

LifecycleNode::Machine::Machine(rclcpp::Node & node, bool enable_communication_interface)
: node_(node)
{
  auto options = rcl_lifecycle_get_default_state_machine_options();
  options.enable_com_interface = false;  // of rcl's own there is only the topic; services are those of any node
  const rcl_ret_t ret = rcl_lifecycle_state_machine_init(
    &machine_, node.get_node_base_interface()->get_rcl_node_handle(),
    ROSIDL_GET_MSG_TYPE_SUPPORT(lifecycle_msgs, msg, TransitionEvent), nullptr, nullptr, nullptr, nullptr,
    nullptr, &options);
  if (ret != RCL_RET_OK) {
    throw std::runtime_error(
            std::string("Couldn't initialize state machine for node ") + node.get_name() + ": " +
            last_error());
  }
  current_ = State(machine_.current_state);
  if (enable_communication_interface) {
    communicate();
  }
}

LifecycleNode::Machine::~Machine()
{
  services_.clear();
  auto * const node = node_.get_node_base_interface()->get_rcl_node_handle();
  if (rcl_lifecycle_state_machine_fini(&machine_, node) != RCL_RET_OK) {
    RCLCPP_FATAL(node_.get_logger(), "failed to destroy rcl_state_machine: %s", last_error().c_str());
  }
}

void LifecycleNode::Machine::communicate()
{
  services_.push_back(
    node_.create_service<ChangeState>(
      "~/change_state",
      [this](ChangeState::Request::SharedPtr request, ChangeState::Response::SharedPtr response) {
        answer(*request, *response);
      }));
  services_.push_back(
    node_.create_service<GetState>(
      "~/get_state", [this](GetState::Request::SharedPtr, GetState::Response::SharedPtr response) {
        const std::lock_guard lock(mutex_);
        response->current_state = message_of(current_);
      }));
  services_.push_back(
    node_.create_service<GetStates>(
      "~/get_available_states",
      [this](GetStates::Request::SharedPtr, GetStates::Response::SharedPtr response) {
        response->available_states = messages_of<lifecycle_msgs::msg::State>(states());
      }));
  using Description = lifecycle_msgs::msg::TransitionDescription;
  services_.push_back(
    node_.create_service<GetTransitions>(
      "~/get_available_transitions",
      [this](GetTransitions::Request::SharedPtr, GetTransitions::Response::SharedPtr response) {
        response->available_transitions = messages_of<Description>(from_here());
      }));
  services_.push_back(
    node_.create_service<GetTransitions>(
      "~/get_transition_graph",
      [this](GetTransitions::Request::SharedPtr, GetTransitions::Response::SharedPtr response) {
        response->available_transitions = messages_of<Description>(transitions());
      }));
}

void LifecycleNode::Machine::answer(ChangeState::Request & request, ChangeState::Response & response)
{
  // A request with a label has no number.
  const auto & asked = request.transition;
  const auto code = asked.label.empty() ? change(asked.id) : change(asked.label.c_str());
  response.success = code == CallbackReturn::SUCCESS;
}

void LifecycleNode::Machine::set_callback(std::uint8_t state, Callback callback)
{
  const std::lock_guard lock(mutex_);
  callbacks_[state] = std::move(callback);
}

void LifecycleNode::Machine::add(std::weak_ptr<ManagedEntityInterface> entity)
{
  const std::lock_guard lock(mutex_);
  entities_.push_back(std::move(entity));
}

void LifecycleNode::Machine::for_each_entity(void (ManagedEntityInterface::* method)())
{
  std::unique_lock lock(mutex_);
  const auto entities = entities_;
  lock.unlock();
  for (const auto & known : entities) {
    if (const auto entity = known.lock()) {
      (entity.get()->*method)();
    }
  }
}

std::vector<State> LifecycleNode::Machine::states() const
{
  const auto & map = machine_.transition_map;
  return made_of<State>(map.states, map.states_size);
}

std::vector<Transition> LifecycleNode::Machine::from_here() const
{
  const std::lock_guard lock(mutex_);
  const auto & here = *machine_.current_state;
  return made_of<Transition>(here.valid_transitions, here.valid_transition_size);
}

std::vector<Transition> LifecycleNode::Machine::transitions() const
{
  const auto & map = machine_.transition_map;
  return made_of<Transition>(map.transitions, map.transitions_size);
}

LifecycleNode::CallbackReturn LifecycleNode::Machine::change(const char * label)
{
  std::unique_lock lock(mutex_);
  const auto * const found = rcl_lifecycle_get_transition_by_label(machine_.current_state, label);
  lock.unlock();
  if (!found) {
    rcl_reset_error();
    return CallbackReturn::ERROR;
  }
  return change(static_cast<std::uint8_t>(found->id));
}

LifecycleNode::CallbackReturn LifecycleNode::Machine::change(std::uint8_t transition_id)
{
  const State before = current_;
  if (!begin(transition_id)) {
    return CallbackReturn::ERROR;
  }
  const auto code = call_back(before);
  if (end(label_of(code)) && code == CallbackReturn::ERROR) {
    RCLCPP_WARN(node_.get_logger(), "Error occurred while doing error handling.");
    end(label_of(call_back(before)));
  }
  return code;
}

bool LifecycleNode::Machine::begin(std::uint8_t transition_id)
{
  const std::lock_guard lock(mutex_);
  if (rcl_lifecycle_trigger_transition_by_id(&machine_, transition_id, true) != RCL_RET_OK) {
    RCLCPP_ERROR(
      node_.get_logger(), "Unable to start transition %u from current state %s: %s", transition_id,
      current_.label().c_str(), last_error().c_str());
    return false;
  }
  current_ = State(machine_.current_state);
  return true;
}

bool LifecycleNode::Machine::end(const char * label)
{
  const std::lock_guard lock(mutex_);
  if (rcl_lifecycle_trigger_transition_by_label(&machine_, label, true) != RCL_RET_OK) {
    RCLCPP_ERROR(
      node_.get_logger(), "Failed to finish transition %s. Current state is now: %s (%s)", label,
      current_.label().c_str(), last_error().c_str());
    return false;
  }
  current_ = State(machine_.current_state);
  return true;
}

LifecycleNode::CallbackReturn LifecycleNode::Machine::call_back(const State & before)
{
  std::unique_lock lock(mutex_);
  const auto found = callbacks_.find(current_.id());
  const auto callback = found == callbacks_.end() ? Callback() : found->second;
  lock.unlock();
  try {
    return callback ? callback(before) : CallbackReturn::SUCCESS;
  } catch (const std::exception & error) {
    RCLCPP_ERROR(node_.get_logger(), "Caught exception in callback for transition %d", current_.id());
    RCLCPP_ERROR(node_.get_logger(), "Original error: %s", error.what());
    return CallbackReturn::ERROR;
  }
}

}  // namespace rclcpp_lifecycle
