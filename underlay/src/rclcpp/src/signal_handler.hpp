#pragma once

#include <semaphore.h>

#include <atomic>
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

  // Held until the thread has ended, so that the thread itself must not ask for it.
  std::mutex mutex_;
  // None while it is not installed.
  std::atomic<SignalHandlerOptions> options_{SignalHandlerOptions::None};
  std::thread thread_;
};

}  // namespace rclcpp::detail
