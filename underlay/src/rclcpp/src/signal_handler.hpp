#pragma once

#include <semaphore.h>

#include <csignal>
#include <mutex>
#include <thread>

#include "rclcpp/utilities.hpp"

namespace rclcpp::detail
{

/// Shuts the contexts down when SIGINT or SIGTERM comes. The handler only wakes a thread, which does it.
class SignalHandler
{
public:
  static SignalHandler & instance();
  SignalHandler(const SignalHandler &) = delete;
  SignalHandler & operator=(const SignalHandler &) = delete;

  /// False when it was installed already.
  bool install(SignalHandlerOptions options);
  bool uninstall();
  bool is_installed();
  SignalHandlerOptions options();

private:
  SignalHandler();
  ~SignalHandler();

  static void handle(int signal_number, siginfo_t * info, void * context);
  void wait_for_signals();

  std::mutex mutex_;
  bool installed_ = false;
  SignalHandlerOptions options_ = SignalHandlerOptions::None;
  std::thread thread_;
};

}  // namespace rclcpp::detail
