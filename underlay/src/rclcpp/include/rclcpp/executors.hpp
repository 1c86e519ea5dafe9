#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "rclcpp/executors/multi_threaded_executor.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp/executors/static_single_threaded_executor.hpp"
#include "rclcpp/experimental/executors/events_executor/events_executor.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp
{

namespace detail
{

/// An executor that has the node; none when the context has ended, as it may at any moment.
std::unique_ptr<executors::SingleThreadedExecutor> executor_for(
  const node_interfaces::NodeBaseInterface::SharedPtr & node);

}  // namespace detail

// These have an executor of their own for the node, for as long as they last.
void spin(node_interfaces::NodeBaseInterface::SharedPtr node_ptr);
void spin(std::shared_ptr<Node> node_ptr);
void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node_ptr);
void spin_some(std::shared_ptr<Node> node_ptr);
void spin_all(
  node_interfaces::NodeBaseInterface::SharedPtr node_ptr, std::chrono::nanoseconds max_duration);
void spin_all(std::shared_ptr<Node> node_ptr, std::chrono::nanoseconds max_duration);

namespace executors
{

using rclcpp::spin;
using rclcpp::spin_some;

template<typename FutureT, typename RepT = std::int64_t, typename PeriodT = std::milli>
FutureReturnCode spin_node_until_future_complete(
  Executor & executor, node_interfaces::NodeBaseInterface::SharedPtr node_ptr, const FutureT & future,
  std::chrono::duration<RepT, PeriodT> timeout = std::chrono::duration<RepT, PeriodT>(-1))
{
  const rclcpp::detail::Visit visit(executor, std::move(node_ptr));
  return executor.spin_until_future_complete(future, timeout);
}

template<typename NodeT, typename FutureT, typename RepT = std::int64_t, typename PeriodT = std::milli>
FutureReturnCode spin_node_until_future_complete(
  Executor & executor, std::shared_ptr<NodeT> node_ptr, const FutureT & future,
  std::chrono::duration<RepT, PeriodT> timeout = std::chrono::duration<RepT, PeriodT>(-1))
{
  return spin_node_until_future_complete(
    executor, node_ptr->get_node_base_interface(), future, timeout);
}

}  // namespace executors

template<typename FutureT, typename RepT = std::int64_t, typename PeriodT = std::milli>
FutureReturnCode spin_until_future_complete(
  node_interfaces::NodeBaseInterface::SharedPtr node_ptr, const FutureT & future,
  std::chrono::duration<RepT, PeriodT> timeout = std::chrono::duration<RepT, PeriodT>(-1))
{
  const auto executor = detail::executor_for(node_ptr);
  return executor ?
         executor->spin_until_future_complete(future, timeout) : FutureReturnCode::INTERRUPTED;
}

template<typename NodeT = Node, typename FutureT, typename RepT = std::int64_t, typename PeriodT = std::milli>
FutureReturnCode spin_until_future_complete(
  std::shared_ptr<NodeT> node_ptr, const FutureT & future,
  std::chrono::duration<RepT, PeriodT> timeout = std::chrono::duration<RepT, PeriodT>(-1))
{
  return rclcpp::spin_until_future_complete(node_ptr->get_node_base_interface(), future, timeout);
}

}  // namespace rclcpp
