#include "rclcpp/detail/event_callback.hpp"

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp::detail
{

namespace
{

/// For C, through which no exception may go.
void call_back(const void * function, std::size_t number_of_events)
{
  try {
    (*static_cast<const EventCallback::Function *>(function))(number_of_events);
  } catch (const std::exception & error) {
    RCLCPP_ERROR(get_logger("rclcpp"), "a callback for new events has thrown: %s", error.what());
  } catch (...) {
    RCLCPP_ERROR(get_logger("rclcpp"), "a callback for new events has thrown");
  }
}

}  // namespace

void EventCallback::set(Function function, const Setter & setter, const char * name)
{
  if (!function) {
    throw std::invalid_argument(
            std::string("The callback passed to ") + name + " is not callable.");
  }
  const std::lock_guard lock(mutex_);
  auto next = std::make_unique<Function>(std::move(function));
  check(setter(call_back, next.get()), "failed to set the callback for new events");
  function_ = std::move(next);
}

void EventCallback::clear(const Setter & setter)
{
  const std::lock_guard lock(mutex_);
  if (function_) {
    check(setter(nullptr, nullptr), "failed to clear the callback for new events");
    function_.reset();
  }
}

}  // namespace rclcpp::detail
