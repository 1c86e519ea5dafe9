#pragma once

#include <memory>
#include <string>

#include "rcl/node.h"
#include "rcpputils/filesystem_helper.hpp"
#include "rcutils/logging.h"

namespace rclcpp
{

class Logger;

Logger get_logger(const std::string & name);

/// Where files of the log are written. Throws RCLError.
rcpputils::fs::path get_logging_directory();

/// The logger of a node, by its handle at rcl; `rclcpp` when there is none.
Logger get_node_logger(const rcl_node_t * node);

/// A name under which messages are logged. Cheap to copy.
class Logger
{
public:
  enum class Level
  {
    Unset = RCUTILS_LOG_SEVERITY_UNSET,
    Debug = RCUTILS_LOG_SEVERITY_DEBUG,
    Info = RCUTILS_LOG_SEVERITY_INFO,
    Warn = RCUTILS_LOG_SEVERITY_WARN,
    Error = RCUTILS_LOG_SEVERITY_ERROR,
    Fatal = RCUTILS_LOG_SEVERITY_FATAL,
  };

  Logger(const Logger &) = default;
  Logger & operator=(const Logger &) = default;

  const char * get_name() const;

  /// A logger `<this name>.<suffix>`; its messages reach /rosout when this one's do.
  Logger get_child(const std::string & suffix);
  void set_level(Level level);
  Level get_effective_level() const;

private:
  friend Logger get_logger(const std::string & name);
  explicit Logger(const std::string & name);

  // The second name is a child's own, as /rosout is to forget it.
  std::shared_ptr<const std::string> name_;
  std::shared_ptr<void> at_rosout_;
};

}  // namespace rclcpp
