#include <algorithm>
#include <utility>

#include "logging_lock.hpp"
#include "rcl/logging.h"
#include "rcl/logging_rosout.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_options.hpp"
#include "rmw/validate_namespace.h"
#include "rmw/validate_node_name.h"
#include "rosout.hpp"

namespace rclcpp::node_interfaces
{

namespace
{

void finish_node(rcl_node_t * node)
{
  const auto mutex = detail::logging_mutex();
  const std::lock_guard lock(*mutex);  // its /rosout is taken from all who log
  detail::end_rosout(*node);
  if (rcl_node_fini(node) != RCL_RET_OK) {
    rcl_reset_error();
  }
  std::default_delete<rcl_node_t>()(node);
}

[[noreturn]] void throw_for(rcl_ret_t ret, const std::string & name, const std::string & name_space)
{
  const exceptions::RCLErrorBase original(ret, rcl_get_error_state());
  rcl_reset_error();
  int result = 0;
  std::size_t index = 0;
  if (ret == RCL_RET_NODE_INVALID_NAME &&
    rmw_validate_node_name(name.c_str(), &result, &index) == RMW_RET_OK)
  {
    throw exceptions::InvalidNodeNameError(
            name.c_str(), rmw_node_name_validation_result_string(result), index);
  }
  if (ret == RCL_RET_NODE_INVALID_NAMESPACE &&
    rmw_validate_namespace(name_space.c_str(), &result, &index) == RMW_RET_OK)
  {
    throw exceptions::InvalidNamespaceError(
            name_space.c_str(), rmw_namespace_validation_result_string(result), index);
  }
  throw exceptions::RCLError(original, "failed to initialize rcl node: ");
}

std::shared_ptr<rcl_node_t> make_node(
  const std::string & name, const std::string & name_space, const rcl_node_options_t & options,
  const std::shared_ptr<rcl_context_t> & context)
{
  const auto mutex = detail::logging_mutex();
  const std::lock_guard lock(*mutex);
  auto node = std::make_unique<rcl_node_t>(rcl_get_zero_initialized_node());
  const rcl_ret_t ret = rcl_node_init(
    node.get(), name.c_str(), name_space.c_str(), context.get(), &options);
  if (ret != RCL_RET_OK) {
    throw_for(ret, name, name_space);
  }
  // The context outlives its nodes.
  std::shared_ptr<rcl_node_t> made(node.release(), [context](rcl_node_t * gone) {finish_node(gone);});
  if (rcl_logging_rosout_enabled() && options.enable_rosout) {
    detail::begin_rosout(*made);
  }
  return made;
}

}  // namespace

NodeBaseInterface::NodeBaseInterface(
  const std::string & node_name, const std::string & node_namespace, const NodeOptions & options)
: NodeBaseInterface(
    node_name, node_namespace, options.context(), *options.get_rcl_node_options(),
    options.use_intra_process_comms(), options.enable_topic_statistics())
{
}

NodeBaseInterface::NodeBaseInterface(
  const std::string & node_name, const std::string & node_namespace, Context::SharedPtr context,
  const rcl_node_options_t & rcl_node_options, bool use_intra_process_default,
  bool enable_topic_statistics_default)
: context_(std::move(context)), use_intra_process_default_(use_intra_process_default),
  enable_topic_statistics_default_(enable_topic_statistics_default)
{
  const GuardCondition tried(context_);  // it says in the usual words when rclcpp::init() was not called
  handle_ = make_node(node_name, node_namespace, rcl_node_options, context_->get_rcl_context());
  default_group_ = create_callback_group(CallbackGroupType::MutuallyExclusive);
}

NodeBaseInterface::~NodeBaseInterface() = default;

const char * NodeBaseInterface::get_name() const
{
  return rcl_node_get_name(handle_.get());
}

const char * NodeBaseInterface::get_namespace() const
{
  return rcl_node_get_namespace(handle_.get());
}

const char * NodeBaseInterface::get_fully_qualified_name() const
{
  return rcl_node_get_fully_qualified_name(handle_.get());
}

CallbackGroup::SharedPtr NodeBaseInterface::create_callback_group(
  CallbackGroupType group_type, bool automatically_add_to_executor_with_node)
{
  auto group = std::make_shared<CallbackGroup>(
    group_type, context_, automatically_add_to_executor_with_node);
  const std::lock_guard lock(mutex_);
  groups_.push_back(group);
  return group;
}

bool NodeBaseInterface::callback_group_in_node(const CallbackGroup::SharedPtr & group)
{
  const std::lock_guard lock(mutex_);
  return std::any_of(
    groups_.begin(), groups_.end(), [&](const auto & known) {return known.lock() == group;});
}

void NodeBaseInterface::for_each_callback_group(
  const std::function<void(CallbackGroup::SharedPtr)> & function)
{
  const std::lock_guard lock(mutex_);
  for (const auto & known : groups_) {
    if (auto group = known.lock()) {
      function(std::move(group));
    }
  }
}

void NodeBaseInterface::add(
  const std::shared_ptr<detail::Entity> & entity, const CallbackGroup::SharedPtr & group)
{
  if (group && !callback_group_in_node(group)) {
    throw std::runtime_error("Cannot create it: the callback group is not in the node.");
  }
  (group ? group : default_group_)->add(entity);
  if (const auto companion = entity->companion()) {
    (group ? group : default_group_)->add(companion);
  }
  std::shared_ptr<GuardCondition> waker;
  {
    const std::lock_guard lock(mutex_);
    waker = waker_.lock();
  }
  if (waker) {
    waker->trigger();
  }
}

void NodeBaseInterface::remove(
  const std::shared_ptr<detail::Entity> & entity, const CallbackGroup::SharedPtr & group)
{
  (group ? group : default_group_)->remove(entity);
}

void NodeBaseInterface::set_waker(const std::shared_ptr<GuardCondition> & waker)
{
  const std::lock_guard lock(mutex_);
  waker_ = waker;
}

}  // namespace rclcpp::node_interfaces
