#include "context_logging.hpp"

#include <cstdarg>

#include "logging_lock.hpp"
#include "rcl/logging.h"
#include "rcl/logging_rosout.h"
#include "rclcpp/detail/check.hpp"
#include "rosout.hpp"

namespace rclcpp::detail
{

namespace
{

struct Shared
{
  std::shared_ptr<std::recursive_mutex> mutex = std::make_shared<std::recursive_mutex>();
  int users = 0;
};

Shared & shared()
{
  // Never destroyed: a node or a logger may be among the last things that a program lets go.
  static Shared & instance = *std::make_unique<Shared>().release();
  return instance;
}

void print(
  const rcutils_log_location_t * location, int severity, const char * name,
  rcutils_time_point_value_t timestamp, const char * format, va_list * words)
{
  const auto mutex = shared().mutex;
  const std::lock_guard lock(*mutex);
  rcl_logging_multiple_output_handler(location, severity, name, timestamp, format, words);
}

}  // namespace

std::shared_ptr<std::recursive_mutex> logging_mutex()
{
  return shared().mutex;
}

Logging::Logging(const rcl_arguments_t & arguments)
{
  const auto mutex = logging_mutex();
  const std::lock_guard lock(*mutex);
  if (shared().users == 0) {
    const rcl_allocator_t allocator = rcl_get_default_allocator();
    check(
      rcl_logging_configure_with_output_handler(&arguments, &allocator, print),
      "failed to configure logging");
  }
  ++shared().users;
}

Logging::~Logging()
{
  const auto mutex = logging_mutex();
  const std::lock_guard lock(*mutex);
  if (--shared().users > 0) {
    return;
  }
  forget_rosout();
  if (rcl_logging_fini() != RCL_RET_OK) {
    rcl_reset_error();
  }
}

}  // namespace rclcpp::detail
