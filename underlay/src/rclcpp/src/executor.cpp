#include "rclcpp/executor.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "executor_waiting.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp
{

namespace
{

using std::chrono::nanoseconds;
using Steady = std::chrono::steady_clock;

/// What is left of a time that began at some point; negative means for ever.
class TimeLeft
{
public:
  explicit TimeLeft(nanoseconds timeout) : timeout_(timeout), began_(Steady::now()) {}

  nanoseconds get() const
  {
    const nanoseconds left = timeout_ - (Steady::now() - began_);
    return timeout_ < nanoseconds(0) ? timeout_ : std::max(left, nanoseconds(0));
  }
  bool is_over() const {return get() == nanoseconds(0);}

private:
  nanoseconds timeout_;
  Steady::time_point began_;
};

/// Names the executor in an error about a node or group that is in another one, or in none.
const char * asked_executor(bool is_in_another)
{
  return is_in_another ? "this executor." : "an executor.";
}

}  // namespace

Executor::Executor(const ExecutorOptions & options)
: context_(options.context),
  interrupt_(std::make_shared<GuardCondition>(options.context)),
  waiting_(std::make_unique<Waiting>(options.context))
{
  on_shutdown_ = context_->add_on_shutdown_callback(
    [waker = std::weak_ptr<GuardCondition>(interrupt_)]() {
      if (const auto interrupt = waker.lock()) {
        interrupt->trigger();
      }
    });
}

Executor::~Executor()
{
  context_->remove_on_shutdown_callback(on_shutdown_);
  for (const auto & known : nodes_) {
    if (const auto node = known.lock()) {
      node->get_associated_with_executor_atomic() = false;
      node->set_waker(nullptr);
    }
  }
  for (const auto & known : groups_) {
    if (const auto group = known.lock()) {
      group->get_associated_with_executor_atomic() = false;
      group->set_waker(nullptr);
    }
  }
}

void Executor::add_node(node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool notify)
{
  if (node_ptr->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error(
            std::string("Node '") + node_ptr->get_fully_qualified_name() +
            "' has already been added to an executor.");
  }
  node_ptr->set_waker(interrupt_);
  {
    const std::lock_guard lock(members_mutex_);
    nodes_.push_back(node_ptr);
  }
  if (notify) {
    interrupt_->trigger();
  }
}

void Executor::add_node(std::shared_ptr<Node> node_ptr, bool notify)
{
  add_node(node_ptr->get_node_base_interface(), notify);
}

void Executor::remove_node(node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool notify)
{
  {
    const std::lock_guard lock(members_mutex_);
    const auto found = std::find_if(
      nodes_.begin(), nodes_.end(), [&](const auto & known) {return known.lock() == node_ptr;});
    if (found == nodes_.end()) {
      throw std::runtime_error(
              std::string("Node '") + node_ptr->get_fully_qualified_name() +
              "' needs to be associated with " +
              asked_executor(node_ptr->get_associated_with_executor_atomic()));
    }
    nodes_.erase(found);
  }
  node_ptr->set_waker(nullptr);
  node_ptr->get_associated_with_executor_atomic() = false;
  if (notify) {
    interrupt_->trigger();
  }
}

void Executor::remove_node(std::shared_ptr<Node> node_ptr, bool notify)
{
  remove_node(node_ptr->get_node_base_interface(), notify);
}

void Executor::add_callback_group(
  CallbackGroup::SharedPtr group_ptr, node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool notify)
{
  const bool is_there_with_node = group_ptr->automatically_add_to_executor_with_node() &&
    node_ptr->get_associated_with_executor_atomic() && node_ptr->callback_group_in_node(group_ptr);
  if (is_there_with_node || group_ptr->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error("Callback group has already been added to an executor.");
  }
  group_ptr->set_waker(interrupt_);
  {
    const std::lock_guard lock(members_mutex_);
    const bool is_here = std::any_of(
      groups_.begin(), groups_.end(), [&](const auto & known) {return known.lock() == group_ptr;});
    if (is_here) {
      throw std::runtime_error("Callback group has already been added to this executor.");
    }
    groups_.push_back(group_ptr);
  }
  if (notify) {
    interrupt_->trigger();
  }
}

void Executor::remove_callback_group(CallbackGroup::SharedPtr group_ptr, bool notify)
{
  {
    const std::lock_guard lock(members_mutex_);
    const auto found = std::find_if(
      groups_.begin(), groups_.end(), [&](const auto & known) {return known.lock() == group_ptr;});
    if (found == groups_.end()) {
      throw std::runtime_error(
              std::string("Callback group needs to be associated with ") +
              asked_executor(group_ptr->get_associated_with_executor_atomic()));
    }
    groups_.erase(found);
  }
  group_ptr->set_waker(nullptr);
  group_ptr->get_associated_with_executor_atomic() = false;
  if (notify) {
    interrupt_->trigger();
  }
}

std::vector<CallbackGroup::WeakPtr> Executor::get_all_callback_groups()
{
  auto all = get_automatically_added_callback_groups_from_nodes();
  const auto others = get_manually_added_callback_groups();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::vector<CallbackGroup::WeakPtr> Executor::get_manually_added_callback_groups()
{
  const std::lock_guard lock(members_mutex_);
  return groups_;
}

std::vector<CallbackGroup::WeakPtr> Executor::get_automatically_added_callback_groups_from_nodes()
{
  const std::lock_guard lock(members_mutex_);
  std::vector<CallbackGroup::WeakPtr> all;
  const auto add = [&](const CallbackGroup::SharedPtr & group) {
      const bool is_others = group->get_associated_with_executor_atomic();
      if (group->automatically_add_to_executor_with_node() && !is_others) {
        all.push_back(group);
      }
    };
  for (const auto & known : nodes_) {
    if (const auto node = known.lock()) {
      node->for_each_callback_group(add);
    }
  }
  return all;
}

Executor::Spinning::Spinning(Executor & executor, const char * function)
: executor_(executor)
{
  if (executor.spinning_.exchange(true)) {
    throw std::runtime_error(std::string(function) + "() called while already spinning");
  }
}

Executor::Spinning::~Spinning()
{
  executor_.spinning_ = false;
}

bool Executor::goes_on() const
{
  return spinning_ && context_->is_valid();
}

void Executor::cancel()
{
  spinning_ = false;
  interrupt_->trigger();
}

void Executor::spin_once(nanoseconds timeout)
{
  const Spinning spinning(*this, "spin_once");
  if (auto ready = next(timeout)) {
    execute(std::move(ready));
  }
}

void Executor::spin_node_once(node_interfaces::NodeBaseInterface::SharedPtr node, nanoseconds timeout)
{
  const detail::Visit visit(*this, std::move(node));
  spin_once(timeout);
}

void Executor::spin_some(nanoseconds max_duration)
{
  spin_ready(max_duration, false);
}

void Executor::spin_all(nanoseconds max_duration)
{
  if (max_duration < nanoseconds(0)) {
    throw std::invalid_argument("max_duration must be greater than or equal to 0");
  }
  spin_ready(max_duration, true);
}

void Executor::spin_node_some(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  const detail::Visit visit(*this, std::move(node));
  spin_some();
}

void Executor::spin_node_all(
  node_interfaces::NodeBaseInterface::SharedPtr node, nanoseconds max_duration)
{
  const detail::Visit visit(*this, std::move(node));
  spin_all(max_duration);
}

void Executor::spin_node_once(const std::shared_ptr<Node> & node, nanoseconds timeout)
{
  spin_node_once(node->get_node_base_interface(), timeout);
}

void Executor::spin_node_some(const std::shared_ptr<Node> & node)
{
  spin_node_some(node->get_node_base_interface());
}

void Executor::spin_node_all(const std::shared_ptr<Node> & node, nanoseconds max_duration)
{
  spin_node_all(node->get_node_base_interface(), max_duration);
}

FutureReturnCode Executor::spin_until(
  const std::function<bool()> & is_ready, nanoseconds timeout)
{
  if (is_ready()) {
    return FutureReturnCode::SUCCESS;
  }
  const Spinning spinning(*this, "spin_until_future_complete");
  const TimeLeft left(timeout);
  while (goes_on()) {
    if (auto ready = next(left.get())) {
      execute(std::move(ready));
    }
    if (is_ready()) {
      return FutureReturnCode::SUCCESS;
    }
    if (left.is_over()) {
      return FutureReturnCode::TIMEOUT;
    }
  }
  return FutureReturnCode::INTERRUPTED;
}

detail::Visit::Visit(Executor & executor, node_interfaces::NodeBaseInterface::SharedPtr node)
: executor_(executor), node_(std::move(node))
{
  executor_.add_node(node_, false);
}

detail::Visit::~Visit()
{
  try {
    executor_.remove_node(node_, false);
  } catch (const std::runtime_error &) {
    // A callback has taken it out already.
  }
}

}  // namespace rclcpp
