#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "rcl/context.h"
#include "rclcpp/init_options.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class ContextAlreadyInitialized : public std::runtime_error
{
public:
  ContextAlreadyInitialized() : std::runtime_error("context is already initialized") {}
};

/// Names one callback of a context.
struct OnShutdownCallbackHandle
{
  std::weak_ptr<std::function<void()>> callback;
};
using PreShutdownCallbackHandle = OnShutdownCallbackHandle;

/// What lies between init and shutdown. Nodes hold on to theirs.
class Context : public std::enable_shared_from_this<Context>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Context)
  using OnShutdownCallback = std::function<void()>;

  Context();
  virtual ~Context();

  /// Reads --ros-args. Throws ContextAlreadyInitialized, RCLInvalidROSArgsError, UnknownROSArgsError.
  virtual void init(
    int argc, char const * const * argv, const InitOptions & init_options = InitOptions());

  /// Between init and shutdown.
  bool is_valid() const;
  const InitOptions & get_init_options() const;
  std::size_t get_domain_id() const;
  std::string shutdown_reason() const;

  /// Ends it: wakes all who wait, then calls the callbacks, whose first exception it throws in the end. False
  /// when it was not running.
  virtual bool shutdown(const std::string & reason);

  virtual OnShutdownCallback on_shutdown(OnShutdownCallback callback);
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(OnShutdownCallback callback);
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle);
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(OnShutdownCallback callback);
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle);

  /// Sleeps until the time is over or the context ends; true when it is still valid.
  bool sleep_for(const std::chrono::nanoseconds & nanoseconds);
  void interrupt_all_sleep();

  /// Sleeps until then, unless `stop` becomes true, which wake_sleepers() has it look at. Whether it is valid.
  bool sleep_unless(const std::chrono::nanoseconds & nanoseconds, const std::atomic_bool & stop);
  void wake_sleepers();

  std::shared_ptr<rcl_context_t> get_rcl_context();

private:
  struct Impl;

  void configure(const rcl_arguments_t & arguments, const std::vector<const char *> & words);

  std::unique_ptr<Impl> impl_;
};

/// Every context that was initialized and is not yet gone.
std::vector<Context::SharedPtr> get_contexts();

}  // namespace rclcpp
