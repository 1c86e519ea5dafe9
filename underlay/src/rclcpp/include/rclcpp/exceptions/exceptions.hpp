#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "rcl/error_handling.h"
#include "rcl/types.h"

namespace rclcpp::exceptions
{

/// The method is not there on this middleware.
class UnimplementedError : public std::runtime_error
{
public:
  UnimplementedError() : std::runtime_error("This code is unimplemented.") {}
  explicit UnimplementedError(const std::string & message) : std::runtime_error(message) {}
};

class InvalidNodeError : public std::runtime_error
{
public:
  InvalidNodeError() : std::runtime_error("node is invalid") {}
};

/// A name of a node, namespace, topic or service is not allowed; tells where it goes wrong.
class NameValidationError : public std::invalid_argument
{
public:
  NameValidationError(
    const char * name_type, const char * name, const char * error_msg, std::size_t invalid_index);

  static std::string format_error(
    const char * name_type, const char * name, const char * error_msg, std::size_t invalid_index);

  const std::string name_type;
  const std::string name;
  const std::string error_msg;
  const std::size_t invalid_index;
};

class InvalidNodeNameError : public NameValidationError
{
public:
  InvalidNodeNameError(const char * name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("node name", name, error_msg, invalid_index) {}
};

class InvalidNamespaceError : public NameValidationError
{
public:
  InvalidNamespaceError(const char * name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("namespace", name, error_msg, invalid_index) {}
};

class InvalidTopicNameError : public NameValidationError
{
public:
  InvalidTopicNameError(const char * name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("topic name", name, error_msg, invalid_index) {}
};

class InvalidServiceNameError : public NameValidationError
{
public:
  InvalidServiceNameError(const char * name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("service name", name, error_msg, invalid_index) {}
};

/// What rcl said of a failure: code, message, file and line.
class RCLErrorBase
{
public:
  RCLErrorBase(rcl_ret_t ret, const rcl_error_state_t * error_state);
  virtual ~RCLErrorBase() = default;

  rcl_ret_t ret;
  std::string message;
  std::string file;
  std::size_t line;
  std::string formatted_message;
};

class RCLError : public RCLErrorBase, public std::runtime_error
{
public:
  RCLError(rcl_ret_t ret, const rcl_error_state_t * error_state, const std::string & prefix)
  : RCLError(RCLErrorBase(ret, error_state), prefix) {}
  RCLError(const RCLErrorBase & base, const std::string & prefix)
  : RCLErrorBase(base), std::runtime_error(prefix + base.formatted_message) {}
};

class RCLBadAlloc : public RCLErrorBase, public std::bad_alloc
{
public:
  RCLBadAlloc(rcl_ret_t ret, const rcl_error_state_t * error_state) : RCLErrorBase(ret, error_state) {}
  explicit RCLBadAlloc(const RCLErrorBase & base) : RCLErrorBase(base) {}
};

class RCLInvalidArgument : public RCLErrorBase, public std::invalid_argument
{
public:
  RCLInvalidArgument(rcl_ret_t ret, const rcl_error_state_t * error_state, const std::string & prefix)
  : RCLInvalidArgument(RCLErrorBase(ret, error_state), prefix) {}
  RCLInvalidArgument(const RCLErrorBase & base, const std::string & prefix)
  : RCLErrorBase(base), std::invalid_argument(prefix + base.formatted_message) {}
};

/// What follows --ros-args cannot be read.
class RCLInvalidROSArgsError : public RCLErrorBase, public std::runtime_error
{
public:
  RCLInvalidROSArgsError(rcl_ret_t ret, const rcl_error_state_t * error_state, const std::string & prefix)
  : RCLInvalidROSArgsError(RCLErrorBase(ret, error_state), prefix) {}
  RCLInvalidROSArgsError(const RCLErrorBase & base, const std::string & prefix)
  : RCLErrorBase(base), std::runtime_error(prefix + base.formatted_message) {}
};

/// Words after --ros-args that are not known there.
class UnknownROSArgsError : public std::runtime_error
{
public:
  explicit UnknownROSArgsError(std::vector<std::string> && unknown_ros_args);

  const std::vector<std::string> unknown_ros_args;
};

class UnsupportedEventTypeException : public RCLErrorBase, public std::runtime_error
{
public:
  UnsupportedEventTypeException(
    rcl_ret_t ret, const rcl_error_state_t * error_state, const std::string & prefix)
  : UnsupportedEventTypeException(RCLErrorBase(ret, error_state), prefix) {}
  UnsupportedEventTypeException(const RCLErrorBase & base, const std::string & prefix)
  : RCLErrorBase(base), std::runtime_error(prefix + (prefix.empty() ? "" : ": ") + base.formatted_message) {}
};

class InvalidEventError : public std::runtime_error
{
public:
  InvalidEventError() : std::runtime_error("event is invalid") {}
};

class EventNotRegisteredError : public std::runtime_error
{
public:
  EventNotRegisteredError() : std::runtime_error("event already registered") {}
};

class InvalidParametersException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidParameterValueException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string & name, const std::string & message)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + message) {}
};

class ParameterAlreadyDeclaredException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterNotDeclaredException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterImmutableException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterModifiedInCallbackException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterUninitializedException : public std::runtime_error
{
public:
  explicit ParameterUninitializedException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' is not initialized") {}
};

class InvalidQosOverridesException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class QoSCheckCompatibleException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

using reset_error_function_t = void (*)();

/// Throws what fits `ret`; `prefix` comes before rcl's own words. Never returns.
[[noreturn]] void throw_from_rcl_error(
  rcl_ret_t ret, const std::string & prefix = "", const rcl_error_state_t * error_state = nullptr,
  reset_error_function_t reset_error = rcl_reset_error);

}  // namespace rclcpp::exceptions
