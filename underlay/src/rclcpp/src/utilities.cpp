#include "rclcpp/utilities.hpp"

#include <exception>
#include <utility>

#include "signal_handler.hpp"

namespace rclcpp
{

namespace
{

Context::SharedPtr or_default(Context::SharedPtr context)
{
  return context ? std::move(context) : contexts::get_global_default_context();
}

// A callback of a shutdown may ask for a shutdown, too. Only the outermost call takes the handlers away: that
// waits for their thread, which in turn may wait for the callback.
thread_local bool is_shutting_down = false;

class Outermost
{
public:
  Outermost() {is_shutting_down = true;}
  Outermost(const Outermost &) = delete;
  Outermost & operator=(const Outermost &) = delete;
  ~Outermost() {is_shutting_down = false;}
};

/// Ends the default context before what it uses goes: the static objects of the libraries it has loaded.
struct EndsWithProgram
{
  EndsWithProgram() = default;
  EndsWithProgram(const EndsWithProgram &) = delete;
  EndsWithProgram & operator=(const EndsWithProgram &) = delete;
  ~EndsWithProgram()
  {
    try {
      shutdown(nullptr, "the program ended");
    } catch (const std::exception &) {
      // A callback of the user's: there is nobody left to be told.
    }
  }
};

}  // namespace

void init(
  int argc, char const * const * argv, const InitOptions & init_options,
  SignalHandlerOptions signal_handler_options)
{
  contexts::get_global_default_context()->init(argc, argv, init_options);
  install_signal_handlers(signal_handler_options);
  static const EndsWithProgram at_exit;
}

bool install_signal_handlers(SignalHandlerOptions signal_handler_options)
{
  return detail::SignalHandler::instance().install(signal_handler_options);
}

bool signal_handlers_installed()
{
  return detail::SignalHandler::instance().is_installed();
}

SignalHandlerOptions get_current_signal_handler_options()
{
  return detail::SignalHandler::instance().options();
}

bool uninstall_signal_handlers()
{
  return detail::SignalHandler::instance().uninstall();
}

bool ok(Context::SharedPtr context)
{
  return or_default(std::move(context))->is_valid();
}

bool shutdown(Context::SharedPtr context, const std::string & reason)
{
  if (is_shutting_down) {
    return or_default(std::move(context))->shutdown(reason);
  }
  const bool is_default = !context || context == contexts::get_global_default_context();
  bool was_running = false;
  {
    const Outermost outermost;
    was_running = or_default(std::move(context))->shutdown(reason);
  }
  if (is_default) {
    uninstall_signal_handlers();
  }
  return was_running;
}

void on_shutdown(std::function<void()> callback, Context::SharedPtr context)
{
  or_default(std::move(context))->on_shutdown(std::move(callback));
}

bool sleep_for(const std::chrono::nanoseconds & nanoseconds, Context::SharedPtr context)
{
  return or_default(std::move(context))->sleep_for(nanoseconds);
}

const char * get_c_string(const char * string_in)
{
  return string_in;
}

const char * get_c_string(const std::string & string_in)
{
  return string_in.c_str();
}

}  // namespace rclcpp
