#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>

#include "rcl/event_callback.h"
#include "rcl/types.h"

namespace rclcpp::detail
{

/// What is called when something new has come for an entity, from a thread of the middleware.
class EventCallback
{
public:
  using Function = std::function<void(std::size_t)>;
  /// Tells rcl; the pointer is what it gives to the function.
  using Setter = std::function<rcl_ret_t(rcl_event_callback_t, const void *)>;

  /// `name` is the method's. Throws std::invalid_argument for an empty function, RCLError.
  void set(Function function, const Setter & setter, const char * name);
  void clear(const Setter & setter);

private:
  std::mutex mutex_;
  std::unique_ptr<Function> function_;
};

}  // namespace rclcpp::detail
