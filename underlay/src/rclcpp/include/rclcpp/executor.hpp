#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/executor_options.hpp"
#include "rclcpp/future_return_code.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{

/// Waits for what the nodes and groups given to it wait for, and calls back.
class Executor
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Executor)
  RCLCPP_DISABLE_COPY(Executor)

  explicit Executor(const ExecutorOptions & options = ExecutorOptions());
  virtual ~Executor();

  /// Works until the context ends or cancel() is called.
  virtual void spin() = 0;

  // Adding throws std::runtime_error for what is in an executor already; removing, for what is not.
  virtual void add_node(node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool notify = true);
  virtual void add_node(std::shared_ptr<Node> node_ptr, bool notify = true);
  virtual void remove_node(node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool notify = true);
  virtual void remove_node(std::shared_ptr<Node> node_ptr, bool notify = true);
  virtual void add_callback_group(
    CallbackGroup::SharedPtr group_ptr, node_interfaces::NodeBaseInterface::SharedPtr node_ptr,
    bool notify = true);
  virtual void remove_callback_group(CallbackGroup::SharedPtr group_ptr, bool notify = true);
  virtual std::vector<CallbackGroup::WeakPtr> get_all_callback_groups();
  virtual std::vector<CallbackGroup::WeakPtr> get_manually_added_callback_groups();
  virtual std::vector<CallbackGroup::WeakPtr> get_automatically_added_callback_groups_from_nodes();

  /// One callback; waits for it no longer than `timeout`, or for ever when that is negative.
  virtual void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void spin_node_once(
    node_interfaces::NodeBaseInterface::SharedPtr node,
    std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void spin_node_once(
    const std::shared_ptr<Node> & node, std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));

  /// What is ready now, each once; no new callback begins after `max_duration`, if that is not zero.
  virtual void spin_some(std::chrono::nanoseconds max_duration = std::chrono::nanoseconds(0));
  /// What is ready, again and again until nothing is.
  virtual void spin_all(std::chrono::nanoseconds max_duration);
  void spin_node_some(node_interfaces::NodeBaseInterface::SharedPtr node);
  void spin_node_some(const std::shared_ptr<Node> & node);
  void spin_node_all(
    node_interfaces::NodeBaseInterface::SharedPtr node, std::chrono::nanoseconds max_duration);
  void spin_node_all(const std::shared_ptr<Node> & node, std::chrono::nanoseconds max_duration);

  /// Works until `future` is ready; SUCCESS, or why not.
  template<typename FutureT, typename RepT = std::int64_t, typename PeriodT = std::milli>
  FutureReturnCode spin_until_future_complete(
    const FutureT & future,
    std::chrono::duration<RepT, PeriodT> timeout = std::chrono::duration<RepT, PeriodT>(-1))
  {
    return spin_until(
      [&future]() {return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;},
      std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

  /// Ends spin(), from any thread.
  virtual void cancel();
  bool is_spinning() {return spinning_;}

protected:
  /// Something that is ready, and the group whose turn it takes.
  struct Ready
  {
    std::shared_ptr<detail::Entity> entity;
    CallbackGroup::SharedPtr group;
    explicit operator bool() const {return entity != nullptr;}
  };

  /// Marks the executor as spinning while it lives. Throws std::runtime_error when it is already.
  class Spinning
  {
public:
    Spinning(Executor & executor, const char * function);
    Spinning(const Spinning &) = delete;
    Spinning & operator=(const Spinning &) = delete;
    ~Spinning();

private:
    Executor & executor_;
  };

  /// Whether to go on.
  bool goes_on() const;

  /// What is to be executed next, waiting up to `timeout` for it; nothing after that, or when woken.
  Ready next(std::chrono::nanoseconds timeout);
  void execute(Ready ready);
  FutureReturnCode spin_until(
    const std::function<bool()> & is_ready, std::chrono::nanoseconds timeout);

  Context::SharedPtr context_;
  std::atomic_bool spinning_{false};

  /// Whether other threads may be waiting while one executes: they are told when a group is free again.
  bool is_shared_ = false;

private:
  struct Waiting;

  // These two are called with wait_mutex_ held.
  void wait(std::chrono::nanoseconds timeout);
  Ready pick();
  void spin_ready(std::chrono::nanoseconds max_duration, bool again);

  std::shared_ptr<GuardCondition> interrupt_;
  OnShutdownCallbackHandle on_shutdown_;
  std::mutex members_mutex_;
  std::vector<node_interfaces::NodeBaseInterface::WeakPtr> nodes_;
  std::vector<CallbackGroup::WeakPtr> groups_;
  // Who holds it waits, or takes what was found ready.
  std::mutex wait_mutex_;
  std::unique_ptr<Waiting> waiting_;
};

namespace detail
{

/// A node is with an executor as long as this lives.
class Visit
{
public:
  Visit(Executor & executor, node_interfaces::NodeBaseInterface::SharedPtr node);
  Visit(const Visit &) = delete;
  Visit & operator=(const Visit &) = delete;
  ~Visit();

private:
  Executor & executor_;
  node_interfaces::NodeBaseInterface::SharedPtr node_;
};

}  // namespace detail
}  // namespace rclcpp
