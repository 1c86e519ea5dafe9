#include "rclcpp/logging.hpp"

#include <cstdarg>
#include <cstdio>
#include <utility>
#include <vector>

#include "deallocate.hpp"
#include "logging_lock.hpp"
#include "rcl/logging_rosout.h"
#include "rcl_logging_interface/rcl_logging_interface.h"
#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

/// While it lives, messages of a child are sent to /rosout by the node of its parent.
class AtRosout
{
public:
  AtRosout(std::shared_ptr<void> parent, std::string name, std::string suffix)
  : parent_(std::move(parent)), name_(std::move(name)), suffix_(std::move(suffix))
  {
    const std::lock_guard lock(*mutex_);
    const rcl_ret_t ret = rcl_logging_rosout_add_sublogger(name_.c_str(), suffix_.c_str());
    if (ret != RCL_RET_OK) {
      rcl_reset_error();
    }
    added_ = ret == RCL_RET_OK;
  }
  AtRosout(const AtRosout &) = delete;
  AtRosout & operator=(const AtRosout &) = delete;
  ~AtRosout()
  {
    const std::lock_guard lock(*mutex_);
    if (added_ && rcl_logging_rosout_remove_sublogger(name_.c_str(), suffix_.c_str()) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

private:
  std::shared_ptr<std::recursive_mutex> mutex_ = detail::logging_mutex();
  std::shared_ptr<void> parent_;
  std::string name_, suffix_;
  bool added_ = false;
};

}  // namespace

Logger get_logger(const std::string & name)
{
  return Logger(name);
}

Logger get_node_logger(const rcl_node_t * node)
{
  const char * name = rcl_node_get_logger_name(node);
  if (!name) {
    rcl_reset_error();
  }
  return get_logger(name ? name : "rclcpp");
}

Logger::Logger(const std::string & name)
: name_(std::make_shared<const std::string>(name))
{
}

const char * Logger::get_name() const
{
  return name_->c_str();
}

Logger Logger::get_child(const std::string & suffix)
{
  Logger child(*name_ + RCUTILS_LOGGING_SEPARATOR_STRING + suffix);
  child.at_rosout_ = std::make_shared<AtRosout>(at_rosout_, *name_, suffix);
  return child;
}

void Logger::set_level(Level level)
{
  const auto mutex = detail::logging_mutex();
  const std::lock_guard lock(*mutex);
  detail::check(
    rcutils_logging_set_logger_level(get_name(), static_cast<int>(level)), "failed to set logger level");
}

Logger::Level Logger::get_effective_level() const
{
  const auto mutex = detail::logging_mutex();
  const std::lock_guard lock(*mutex);
  const int level = rcutils_logging_get_logger_effective_level(get_name());
  if (level < 0) {
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "couldn't get logger level");
  }
  return static_cast<Level>(level);
}

bool detail::is_logged(const Logger & logger, int severity)
{
  const auto mutex = logging_mutex();
  const std::lock_guard lock(*mutex);
  RCUTILS_LOGGING_AUTOINIT;
  return rcutils_logging_logger_is_enabled_for(logger.get_name(), severity);
}

void detail::log(
  const rcutils_log_location_t & location, int severity, const Logger & logger, const char * format, ...)
{
  va_list words, again;
  va_start(words, format);
  va_copy(again, words);
  const int length = std::vsnprintf(nullptr, 0, format, words);
  va_end(words);
  std::vector<char> text(length < 0 ? 1 : static_cast<std::size_t>(length) + 1);
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  const auto mutex = logging_mutex();
  const std::lock_guard lock(*mutex);
  rcutils_log_internal(&location, severity, logger.get_name(), "%s", text.data());
}

bool detail::is_due(std::atomic<std::int64_t> & last, std::int64_t now, double milliseconds)
{
  const auto period = static_cast<std::int64_t>(milliseconds * 1e6);
  std::int64_t before = last.load();
  const bool due = now >= before + period || now < before;
  return due && last.compare_exchange_strong(before, now);
}

rcpputils::fs::path get_logging_directory()
{
  char * found = nullptr;
  detail::check(
    rcl_logging_get_logging_directory(rcl_get_default_allocator(), &found),
    "failed to get the logging directory");
  const std::unique_ptr<char, detail::Deallocate> directory(found);
  return rcpputils::fs::path(directory.get());
}

}  // namespace rclcpp
