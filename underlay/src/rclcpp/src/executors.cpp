#include "rclcpp/executors.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace rclcpp
{

std::unique_ptr<executors::SingleThreadedExecutor> detail::executor_for(
  const node_interfaces::NodeBaseInterface::SharedPtr & node)
{
  ExecutorOptions options;
  options.context = node->get_context();
  try {
    auto executor = std::make_unique<executors::SingleThreadedExecutor>(options);
    executor->add_node(node, false);
    return executor;
  } catch (const exceptions::RCLError &) {
    if (options.context->is_valid()) {
      throw;
    }
    return nullptr;
  }
}

void executors::SingleThreadedExecutor::spin()
{
  const Spinning spinning(*this, "spin");
  while (goes_on()) {
    if (auto ready = next(std::chrono::nanoseconds(-1))) {
      execute(std::move(ready));
    }
  }
}

executors::MultiThreadedExecutor::MultiThreadedExecutor(
  const ExecutorOptions & options, std::size_t number_of_threads, bool yield_before_execute,
  std::chrono::nanoseconds timeout)
: Executor(options),
  number_of_threads_(
    number_of_threads > 0 ? number_of_threads : std::max(std::thread::hardware_concurrency(), 2u)),
  yield_before_execute_(yield_before_execute), timeout_(timeout)
{
  is_shared_ = true;
}

void executors::MultiThreadedExecutor::spin()
{
  const Spinning spinning(*this, "spin");
  std::mutex mutex;
  std::exception_ptr failure;
  const auto attempt = [&](const auto & action) {
      try {
        action();
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = failure ? failure : std::current_exception();
        cancel();  // all the threads must end before it can be passed on
      }
    };
  const auto work = [&]() {attempt([this]() {run();});};
  std::vector<std::thread> others;
  attempt(
    [&]() {
      while (others.size() + 1 < number_of_threads_) {
        others.emplace_back(work);
      }
    });
  work();
  for (auto & other : others) {
    other.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

void executors::MultiThreadedExecutor::run()
{
  while (goes_on()) {
    if (auto ready = next(timeout_)) {
      if (yield_before_execute_) {
        std::this_thread::yield();
      }
      execute(std::move(ready));
    }
  }
}

void spin(node_interfaces::NodeBaseInterface::SharedPtr node_ptr)
{
  if (const auto executor = detail::executor_for(node_ptr)) {
    executor->spin();
  }
}

void spin(std::shared_ptr<Node> node_ptr)
{
  spin(node_ptr->get_node_base_interface());
}

void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node_ptr)
{
  if (const auto executor = detail::executor_for(node_ptr)) {
    executor->spin_some();
  }
}

void spin_some(std::shared_ptr<Node> node_ptr)
{
  spin_some(node_ptr->get_node_base_interface());
}

void spin_all(
  node_interfaces::NodeBaseInterface::SharedPtr node_ptr, std::chrono::nanoseconds max_duration)
{
  if (const auto executor = detail::executor_for(node_ptr)) {
    executor->spin_all(max_duration);
  }
}

void spin_all(std::shared_ptr<Node> node_ptr, std::chrono::nanoseconds max_duration)
{
  spin_all(node_ptr->get_node_base_interface(), max_duration);
}

std::string to_string(const FutureReturnCode & future_return_code)
{
  const auto number = static_cast<std::underlying_type_t<FutureReturnCode>>(future_return_code);
  const auto numbered = " (" + std::to_string(number) + ")";
  switch (future_return_code) {
    case FutureReturnCode::SUCCESS:
      return "SUCCESS" + numbered;
    case FutureReturnCode::INTERRUPTED:
      return "INTERRUPTED" + numbered;
    case FutureReturnCode::TIMEOUT:
      return "TIMEOUT" + numbered;
    default:
      return "Unknown enum value" + numbered;
  }
}

std::ostream & operator<<(std::ostream & os, const FutureReturnCode & future_return_code)
{
  return os << to_string(future_return_code);
}

}  // namespace rclcpp
