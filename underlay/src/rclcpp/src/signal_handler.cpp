#include "signal_handler.hpp"

#include <atomic>
#include <cerrno>
#include <exception>
#include <system_error>

#include "rclcpp/logging.hpp"

namespace rclcpp::detail
{

namespace
{

// A signal's handler may touch no more than this.
struct Mailbox
{
  sem_t filled;
  std::atomic<int> signal_number{0};
  std::atomic<bool> stopped{false};
  struct sigaction earlier_int, earlier_term;
};

thread_local bool is_own_thread = false;

Mailbox & mailbox()
{
  static Mailbox instance;
  return instance;
}

bool covers(SignalHandlerOptions options, int signal_number)
{
  return options == SignalHandlerOptions::All ||
         options == (signal_number == SIGINT ? SignalHandlerOptions::SigInt : SignalHandlerOptions::SigTerm);
}

void change(int signal_number, const struct sigaction & action, struct sigaction * earlier)
{
  if (sigaction(signal_number, &action, earlier) != 0) {
    throw std::system_error(errno, std::generic_category(), "failed to set a signal handler");
  }
}

void call(const struct sigaction & earlier, int signal_number, siginfo_t * info, void * context)
{
  if (earlier.sa_flags & SA_SIGINFO) {
    if (earlier.sa_sigaction) {
      earlier.sa_sigaction(signal_number, info, context);
    }
  } else if (earlier.sa_handler != SIG_DFL && earlier.sa_handler != SIG_IGN) {
    earlier.sa_handler(signal_number);
  }
}

void shut_down(Context & context)
{
  try {
    context.shutdown("signal handler");
  } catch (const std::exception & error) {
    // Of a callback of the user's, and here is nobody who could catch it.
    RCLCPP_ERROR(get_logger("rclcpp"), "while shutting down: %s", error.what());
  }
}

}  // namespace

SignalHandler & SignalHandler::instance()
{
  static SignalHandler handler;
  return handler;
}

SignalHandler::SignalHandler()
{
  // What its thread uses is made first, so that it lives longer.
  contexts::get_global_default_context();
  sem_init(&mailbox().filled, 0, 0);
}

SignalHandler::~SignalHandler()
{
  try {
    uninstall();
  } catch (const std::system_error &) {
    // The program is ending.
  }
  sem_destroy(&mailbox().filled);
}

bool SignalHandler::install(SignalHandlerOptions options)
{
  const std::lock_guard lock(mutex_);
  if (is_installed() || options == SignalHandlerOptions::None) {
    return false;
  }
  mailbox().stopped = false;
  mailbox().signal_number = 0;
  thread_ = std::thread(&SignalHandler::wait_for_signals, this);
  options_ = options;
  struct sigaction action = {};
  action.sa_sigaction = &SignalHandler::handle;
  action.sa_flags = SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  if (covers(options, SIGINT)) {
    change(SIGINT, action, &mailbox().earlier_int);
  }
  if (covers(options, SIGTERM)) {
    change(SIGTERM, action, &mailbox().earlier_term);
  }
  return true;
}

bool SignalHandler::uninstall()
{
  if (is_own_thread) {
    return false;  // a callback of its shutdown asks; the thread that waits for this one holds the lock
  }
  const std::lock_guard lock(mutex_);
  if (!is_installed()) {
    return false;
  }
  if (covers(options_, SIGINT)) {
    change(SIGINT, mailbox().earlier_int, nullptr);
  }
  if (covers(options_, SIGTERM)) {
    change(SIGTERM, mailbox().earlier_term, nullptr);
  }
  options_ = SignalHandlerOptions::None;
  mailbox().stopped = true;
  sem_post(&mailbox().filled);
  thread_.join();
  return true;
}

bool SignalHandler::is_installed()
{
  return options_ != SignalHandlerOptions::None;
}

SignalHandlerOptions SignalHandler::options()
{
  return options_;
}

void SignalHandler::handle(int signal_number, siginfo_t * info, void * context)
{
  const int kept = errno;
  mailbox().signal_number = signal_number;
  sem_post(&mailbox().filled);
  const auto & box = mailbox();
  call(signal_number == SIGINT ? box.earlier_int : box.earlier_term, signal_number, info, context);
  errno = kept;
}

void SignalHandler::wait_for_signals()
{
  is_own_thread = true;
  auto & box = mailbox();
  while (!box.stopped) {
    while (sem_wait(&box.filled) != 0) {
      // Interrupted: by the very signal, as it may be.
    }
    const int signal_number = box.signal_number.exchange(0);
    if (signal_number == 0) {
      continue;
    }
    RCLCPP_INFO(get_logger("rclcpp"), "signal_handler(signum=%d)", signal_number);
    for (const auto & known : get_contexts()) {
      if (known->get_init_options().shutdown_on_signal) {
        shut_down(*known);
      }
    }
  }
}

}  // namespace rclcpp::detail
