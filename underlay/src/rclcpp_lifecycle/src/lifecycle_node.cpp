#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include <utility>

#include "lifecycle_msgs/msg/state.hpp"
#include "machine.hpp"

namespace rclcpp_lifecycle
{

namespace
{

using Between = lifecycle_msgs::msg::State;

}  // namespace

LifecycleNode::LifecycleNode(
  const std::string & node_name, const rclcpp::NodeOptions & options, bool enable_communication_interface)
: LifecycleNode(node_name, "", options, enable_communication_interface)
{
}

LifecycleNode::LifecycleNode(
  const std::string & node_name, const std::string & namespace_, const rclcpp::NodeOptions & options,
  bool enable_communication_interface)
: Node(node_name, namespace_, options),
  machine_(std::make_unique<Machine>(*this, enable_communication_interface))
{
  register_on_configure([this](const State & before) {return on_configure(before);});
  register_on_cleanup([this](const State & before) {return on_cleanup(before);});
  register_on_shutdown([this](const State & before) {return on_shutdown(before);});
  register_on_activate([this](const State & before) {return on_activate(before);});
  register_on_deactivate([this](const State & before) {return on_deactivate(before);});
  register_on_error([this](const State & before) {return on_error(before);});
}

LifecycleNode::~LifecycleNode() = default;

const State & LifecycleNode::get_current_state() const
{
  return machine_->current();
}

std::vector<State> LifecycleNode::get_available_states() const
{
  return machine_->states();
}

std::vector<Transition> LifecycleNode::get_available_transitions() const
{
  return machine_->from_here();
}

std::vector<Transition> LifecycleNode::get_transition_graph() const
{
  return machine_->transitions();
}

const State & LifecycleNode::trigger_transition(const Transition & transition)
{
  return trigger_transition(transition.id());
}

const State & LifecycleNode::trigger_transition(
  const Transition & transition, CallbackReturn & cb_return_code)
{
  return trigger_transition(transition.id(), cb_return_code);
}

const State & LifecycleNode::trigger_transition(std::uint8_t transition_id)
{
  CallbackReturn ignored;
  return trigger_transition(transition_id, ignored);
}

const State & LifecycleNode::trigger_transition(std::uint8_t transition_id, CallbackReturn & cb_return_code)
{
  cb_return_code = machine_->change(transition_id);
  return get_current_state();
}

const State & LifecycleNode::trigger(const char * label, CallbackReturn & cb_return_code)
{
  cb_return_code = machine_->change(label);
  return get_current_state();
}

const State & LifecycleNode::configure()
{
  CallbackReturn ignored;
  return configure(ignored);
}

const State & LifecycleNode::configure(CallbackReturn & cb_return_code)
{
  return trigger(rcl_lifecycle_configure_label, cb_return_code);
}

const State & LifecycleNode::cleanup()
{
  CallbackReturn ignored;
  return cleanup(ignored);
}

const State & LifecycleNode::cleanup(CallbackReturn & cb_return_code)
{
  return trigger(rcl_lifecycle_cleanup_label, cb_return_code);
}

const State & LifecycleNode::activate()
{
  CallbackReturn ignored;
  return activate(ignored);
}

const State & LifecycleNode::activate(CallbackReturn & cb_return_code)
{
  return trigger(rcl_lifecycle_activate_label, cb_return_code);
}

const State & LifecycleNode::deactivate()
{
  CallbackReturn ignored;
  return deactivate(ignored);
}

const State & LifecycleNode::deactivate(CallbackReturn & cb_return_code)
{
  return trigger(rcl_lifecycle_deactivate_label, cb_return_code);
}

const State & LifecycleNode::shutdown()
{
  CallbackReturn ignored;
  return shutdown(ignored);
}

const State & LifecycleNode::shutdown(CallbackReturn & cb_return_code)
{
  return trigger(rcl_lifecycle_shutdown_label, cb_return_code);
}

bool LifecycleNode::register_on_configure(Callback callback)
{
  machine_->set_callback(Between::TRANSITION_STATE_CONFIGURING, std::move(callback));
  return true;
}

bool LifecycleNode::register_on_cleanup(Callback callback)
{
  machine_->set_callback(Between::TRANSITION_STATE_CLEANINGUP, std::move(callback));
  return true;
}

bool LifecycleNode::register_on_shutdown(Callback callback)
{
  machine_->set_callback(Between::TRANSITION_STATE_SHUTTINGDOWN, std::move(callback));
  return true;
}

bool LifecycleNode::register_on_activate(Callback callback)
{
  machine_->set_callback(Between::TRANSITION_STATE_ACTIVATING, std::move(callback));
  return true;
}

bool LifecycleNode::register_on_deactivate(Callback callback)
{
  machine_->set_callback(Between::TRANSITION_STATE_DEACTIVATING, std::move(callback));
  return true;
}

bool LifecycleNode::register_on_error(Callback callback)
{
  machine_->set_callback(Between::TRANSITION_STATE_ERRORPROCESSING, std::move(callback));
  return true;
}

LifecycleNode::CallbackReturn LifecycleNode::on_activate(const State &)
{
  machine_->for_each_entity(&ManagedEntityInterface::on_activate);
  return CallbackReturn::SUCCESS;
}

LifecycleNode::CallbackReturn LifecycleNode::on_deactivate(const State &)
{
  machine_->for_each_entity(&ManagedEntityInterface::on_deactivate);
  return CallbackReturn::SUCCESS;
}

void LifecycleNode::add_managed_entity(std::weak_ptr<ManagedEntityInterface> managed_entity)
{
  machine_->add(std::move(managed_entity));
}

}  // namespace rclcpp_lifecycle
