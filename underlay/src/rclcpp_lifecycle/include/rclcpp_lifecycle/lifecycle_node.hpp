#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "rclcpp_lifecycle/transition.hpp"
#include "rclcpp_lifecycle/visibility_control.h"

namespace rclcpp_lifecycle
{

/// A node that others configure, activate and end, step by step. Its publishers are quiet while it is not
/// active.
class LifecycleNode : public node_interfaces::LifecycleNodeInterface, public rclcpp::Node
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)
  RCLCPP_DISABLE_COPY(LifecycleNode)
  using Callback = std::function<CallbackReturn(const State &)>;

  /// Without a communication interface, only the program itself changes the state.
  explicit LifecycleNode(
    const std::string & node_name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(),
    bool enable_communication_interface = true);
  LifecycleNode(
    const std::string & node_name, const std::string & namespace_,
    const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool enable_communication_interface = true);
  ~LifecycleNode() override;

  std::shared_ptr<LifecycleNode> shared_from_this()
  {
    return std::static_pointer_cast<LifecycleNode>(Node::shared_from_this());
  }
  std::shared_ptr<const LifecycleNode> shared_from_this() const
  {
    return std::static_pointer_cast<const LifecycleNode>(Node::shared_from_this());
  }

  template<typename MessageT, typename AllocatorT = std::allocator<void>>
  std::shared_ptr<LifecyclePublisher<MessageT, AllocatorT>> create_publisher(
    const std::string & topic_name, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT> & options =
    rclcpp::PublisherOptionsWithAllocator<AllocatorT>())
  {
    auto publisher =
      Node::create_publisher<MessageT, AllocatorT, LifecyclePublisher<MessageT, AllocatorT>>(
      topic_name, qos, options);
    add_managed_entity(publisher);
    return publisher;
  }

  const State & get_current_state() const;
  std::vector<State> get_available_states() const;
  /// Those from the current state.
  std::vector<Transition> get_available_transitions() const;
  std::vector<Transition> get_transition_graph() const;

  // All of these give the state after it, and tell what the callback gave back. What does not go in the
  // current state is logged, and changes nothing.
  const State & trigger_transition(const Transition & transition);
  const State & trigger_transition(const Transition & transition, CallbackReturn & cb_return_code);
  const State & trigger_transition(std::uint8_t transition_id);
  const State & trigger_transition(std::uint8_t transition_id, CallbackReturn & cb_return_code);
  const State & configure();
  const State & configure(CallbackReturn & cb_return_code);
  const State & cleanup();
  const State & cleanup(CallbackReturn & cb_return_code);
  const State & activate();
  const State & activate(CallbackReturn & cb_return_code);
  const State & deactivate();
  const State & deactivate(CallbackReturn & cb_return_code);
  const State & shutdown();
  const State & shutdown(CallbackReturn & cb_return_code);

  // Instead of the methods. An exception counts as CallbackReturn::ERROR.
  bool register_on_configure(Callback callback);
  bool register_on_cleanup(Callback callback);
  bool register_on_shutdown(Callback callback);
  bool register_on_activate(Callback callback);
  bool register_on_deactivate(Callback callback);
  bool register_on_error(Callback callback);

  /// Switches publishers on and off. To be called by methods that override these.
  CallbackReturn on_activate(const State & previous_state) override;
  CallbackReturn on_deactivate(const State & previous_state) override;

protected:
  /// Something else that is to be switched on and off with the node.
  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> managed_entity);
  /// Does nothing, as in the real one: timers run in all states.
  void add_timer_handle(const std::shared_ptr<rclcpp::TimerBase> &) {}

private:
  class Machine;

  const State & trigger(const char * label, CallbackReturn & cb_return_code);

  std::unique_ptr<Machine> machine_;
};

}  // namespace rclcpp_lifecycle
