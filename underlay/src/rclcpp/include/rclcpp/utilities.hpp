#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/init_options.hpp"

namespace rclcpp
{

/// Which signals end the program's contexts. With None they stay with the program.
enum class SignalHandlerOptions
{
  All,
  SigInt,
  SigTerm,
  None,
};

/// Begins: reads --ros-args, configures logging, handles signals.
void init(
  int argc, char const * const * argv, const InitOptions & init_options = InitOptions(),
  SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All);

bool install_signal_handlers(SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All);
bool signal_handlers_installed();
SignalHandlerOptions get_current_signal_handler_options();
bool uninstall_signal_handlers();

/// init, and the words that are not for ROS.
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & init_options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);

/// Between init and shutdown, of `context` or the default one.
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(
  Context::SharedPtr context = nullptr, const std::string & reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void()> callback, Context::SharedPtr context = nullptr);

/// Sleeps; a shutdown ends it early, and then it returns false.
bool sleep_for(const std::chrono::nanoseconds & nanoseconds, Context::SharedPtr context = nullptr);

/// Whether x + y, or x - y, is outside of what T can hold.
template<typename T>
bool add_will_overflow(const T x, const T y)
{
  T result;
  return __builtin_add_overflow(x, y, &result) && y > 0;
}

template<typename T>
bool add_will_underflow(const T x, const T y)
{
  T result;
  return __builtin_add_overflow(x, y, &result) && y < 0;
}

template<typename T>
bool sub_will_overflow(const T x, const T y)
{
  T result;
  return __builtin_sub_overflow(x, y, &result) && y < 0;
}

template<typename T>
bool sub_will_underflow(const T x, const T y)
{
  T result;
  return __builtin_sub_overflow(x, y, &result) && y > 0;
}

const char * get_c_string(const char * string_in);
const char * get_c_string(const std::string & string_in);

}  // namespace rclcpp
