#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rcl/node.h"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
class NodeOptions;

namespace node_interfaces
{

/// What an executor knows about a node: its handle at rcl, its callback groups, and how to be told of changes.
class NodeBaseInterface : public std::enable_shared_from_this<NodeBaseInterface>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(NodeBaseInterface)

  /// Throws InvalidNodeNameError, InvalidNamespaceError, RCLError.
  NodeBaseInterface(
    const std::string & node_name, const std::string & node_namespace, const NodeOptions & options);
  NodeBaseInterface(
    const std::string & node_name, const std::string & node_namespace, Context::SharedPtr context,
    const rcl_node_options_t & rcl_node_options, bool use_intra_process_default,
    bool enable_topic_statistics_default = false);
  ~NodeBaseInterface();

  const char * get_name() const;
  const char * get_namespace() const;
  const char * get_fully_qualified_name() const;
  Context::SharedPtr get_context() {return context_;}
  rcl_node_t * get_rcl_node_handle() {return handle_.get();}
  std::shared_ptr<rcl_node_t> get_shared_rcl_node_handle() {return handle_;}

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType group_type, bool automatically_add_to_executor_with_node = true);
  CallbackGroup::SharedPtr get_default_callback_group() {return default_group_;}
  bool callback_group_in_node(const CallbackGroup::SharedPtr & group);
  void for_each_callback_group(const std::function<void(CallbackGroup::SharedPtr)> & function);

  /// Whether messages are handed over within the process where an entity does not say otherwise.
  bool get_use_intra_process_default() const {return use_intra_process_default_;}
  bool get_enable_topic_statistics_default() const {return enable_topic_statistics_default_;}

  /// Whether an executor has it; set by the executor alone.
  std::atomic_bool & get_associated_with_executor_atomic() {return associated_;}

  /// Adds to `group`, or to the default one, and tells the executors of both.
  void add(const std::shared_ptr<detail::Entity> & entity, const CallbackGroup::SharedPtr & group);

  void remove(const std::shared_ptr<detail::Entity> & entity, const CallbackGroup::SharedPtr & group);

  /// Whom to wake when something is added.
  void set_waker(const std::shared_ptr<GuardCondition> & waker);

  std::string resolve_topic_or_service_name(
    const std::string & name, bool is_service, bool only_expand = false) const;

private:
  Context::SharedPtr context_;
  const bool use_intra_process_default_, enable_topic_statistics_default_;
  std::shared_ptr<rcl_node_t> handle_;
  CallbackGroup::SharedPtr default_group_;
  std::atomic_bool associated_{false};
  std::mutex mutex_;
  std::vector<std::weak_ptr<CallbackGroup>> groups_;
  std::weak_ptr<GuardCondition> waker_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
