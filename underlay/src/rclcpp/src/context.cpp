#include "rclcpp/context.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <optional>
#include <utility>

#include "arguments.hpp"
#include "context_logging.hpp"
#include "rcl/init.h"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

struct Registry
{
  std::mutex mutex;
  std::vector<std::weak_ptr<Context>> contexts;
};

Registry & registry()
{
  static Registry instance;
  return instance;
}

void remember(const Context::SharedPtr & context)
{
  const std::lock_guard lock(registry().mutex);
  auto & all = registry().contexts;
  all.erase(
    std::remove_if(all.begin(), all.end(), [](const auto & other) {return other.expired();}), all.end());
  all.push_back(context);
}

void finish_context(rcl_context_t * context)
{
  if (rcl_context_is_valid(context) && rcl_shutdown(context) != RCL_RET_OK) {
    rcl_reset_error();
  }
  if (rcl_context_fini(context) != RCL_RET_OK) {
    rcl_reset_error();
  }
  std::default_delete<rcl_context_t>()(context);
}

using Callback = std::shared_ptr<std::function<void()>>;

bool remove(std::vector<Callback> & callbacks, const OnShutdownCallbackHandle & handle)
{
  const auto found = std::find(callbacks.begin(), callbacks.end(), handle.callback.lock());
  if (found == callbacks.end()) {
    return false;
  }
  callbacks.erase(found);
  return true;
}

/// Calls all of them; the first exception of any comes when the last was called.
void call(const std::vector<Callback> & callbacks)
{
  std::exception_ptr failure;
  for (const auto & callback : callbacks) {
    try {
      (*callback)();
    } catch (...) {
      failure = failure ? failure : std::current_exception();
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

}  // namespace

struct Context::Impl
{
  // Asked in every turn of a loop, also by those whom a shutdown wakes: no lock.
  std::atomic<bool> valid{false};

  // Held for init and shutdown as a whole, callbacks of the user's included.
  std::recursive_mutex mutex;
  std::optional<detail::Logging> logging;
  InitOptions options;

  // Never held for long: those whom a callback waits for may ask for these.
  mutable std::mutex facts_mutex;
  std::shared_ptr<rcl_context_t> rcl_context;
  std::string reason;

  std::mutex callbacks_mutex;
  std::vector<Callback> on_shutdown, pre_shutdown;

  std::mutex sleep_mutex;
  std::condition_variable awake;
  std::size_t interruptions = 0;

  std::shared_ptr<rcl_context_t> handle() const
  {
    const std::lock_guard lock(facts_mutex);
    return rcl_context;
  }

  void note(std::shared_ptr<rcl_context_t> fresh, const std::string & why)
  {
    const std::lock_guard lock(facts_mutex);
    rcl_context.swap(fresh);  // the one before may go when the mutex is free again
    reason = why;
  }

  OnShutdownCallbackHandle add(std::vector<Callback> & callbacks, OnShutdownCallback callback)
  {
    const std::lock_guard lock(callbacks_mutex);
    callbacks.push_back(std::make_shared<std::function<void()>>(std::move(callback)));
    return {callbacks.back()};
  }

  std::vector<Callback> copy(const std::vector<Callback> & callbacks)
  {
    const std::lock_guard lock(callbacks_mutex);
    return callbacks;
  }
};

Context::Context()
: impl_(std::make_unique<Impl>())
{
}

Context::~Context()
{
  try {
    shutdown("context destructor was called while still not shutdown");
  } catch (const std::exception &) {
    // A callback of the user's: there is nobody left to be told.
    rcl_reset_error();
  }
}

void Context::init(int argc, char const * const * argv, const InitOptions & init_options)
{
  const std::lock_guard lock(impl_->mutex);
  if (is_valid()) {
    throw ContextAlreadyInitialized();
  }
  auto fresh = std::make_unique<rcl_context_t>(rcl_get_zero_initialized_context());
  const rcl_ret_t ret = rcl_init(argc, argv, init_options.get_rcl_init_options(), fresh.get());
  detail::check(ret, "failed to initialize rcl");
  const std::shared_ptr<rcl_context_t> begun(fresh.release(), finish_context);
  impl_->note(begun, "");
  impl_->options = init_options;
  impl_->valid = true;
  try {
    configure(begun->global_arguments, {argv, argv + argc});
  } catch (...) {
    shutdown("it could not be configured");
    throw;
  }
  if (const auto self = weak_from_this().lock()) {
    remember(self);
  }
}

void Context::configure(const rcl_arguments_t & arguments, const std::vector<const char *> & words)
{
  if (impl_->options.auto_initialize_logging()) {
    impl_->logging.emplace(arguments);
  }
  auto unknown = detail::unknown_ros_arguments(arguments, words);
  if (!unknown.empty()) {
    throw exceptions::UnknownROSArgsError(std::move(unknown));
  }
}

bool Context::is_valid() const
{
  return impl_->valid;
}

const InitOptions & Context::get_init_options() const
{
  return impl_->options;
}

std::size_t Context::get_domain_id() const
{
  std::size_t domain_id = 0;
  detail::check(
    rcl_context_get_domain_id(impl_->handle().get(), &domain_id), "failed to get domain id from context");
  return domain_id;
}

std::string Context::shutdown_reason() const
{
  const std::lock_guard lock(impl_->facts_mutex);
  return impl_->reason;
}

bool Context::shutdown(const std::string & reason)
{
  const std::lock_guard lock(impl_->mutex);
  if (!is_valid()) {
    return false;
  }
  call(impl_->copy(impl_->pre_shutdown));
  impl_->valid = false;  // what fails from now on can see why
  const auto handle = impl_->handle();
  impl_->note(handle, reason);
  detail::check(rcl_shutdown(handle.get()), "failed to shutdown rcl context");
  interrupt_all_sleep();
  call(impl_->copy(impl_->on_shutdown));
  impl_->logging.reset();
  return true;
}

Context::OnShutdownCallback Context::on_shutdown(OnShutdownCallback callback)
{
  add_on_shutdown_callback(callback);
  return callback;
}

OnShutdownCallbackHandle Context::add_on_shutdown_callback(OnShutdownCallback callback)
{
  return impl_->add(impl_->on_shutdown, std::move(callback));
}

bool Context::remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle)
{
  const std::lock_guard lock(impl_->callbacks_mutex);
  return remove(impl_->on_shutdown, handle);
}

PreShutdownCallbackHandle Context::add_pre_shutdown_callback(OnShutdownCallback callback)
{
  return impl_->add(impl_->pre_shutdown, std::move(callback));
}

bool Context::remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle)
{
  const std::lock_guard lock(impl_->callbacks_mutex);
  return remove(impl_->pre_shutdown, handle);
}

bool Context::sleep_for(const std::chrono::nanoseconds & nanoseconds)
{
  const std::atomic_bool never{false};
  return sleep_unless(nanoseconds, never);
}

bool Context::sleep_unless(const std::chrono::nanoseconds & nanoseconds, const std::atomic_bool & stop)
{
  const auto until = std::chrono::steady_clock::now() + nanoseconds;
  {
    std::unique_lock lock(impl_->sleep_mutex);
    const auto before = impl_->interruptions;
    impl_->awake.wait_until(
      lock, until, [&] {return impl_->interruptions != before || !is_valid() || stop;});
  }
  return is_valid();
}

void Context::wake_sleepers()
{
  const std::lock_guard lock(impl_->sleep_mutex);
  impl_->awake.notify_all();
}

void Context::interrupt_all_sleep()
{
  const std::lock_guard lock(impl_->sleep_mutex);
  ++impl_->interruptions;
  impl_->awake.notify_all();
}

std::shared_ptr<rcl_context_t> Context::get_rcl_context()
{
  return impl_->handle();
}

std::vector<Context::SharedPtr> get_contexts()
{
  std::vector<Context::SharedPtr> alive;
  const std::lock_guard lock(registry().mutex);
  for (const auto & known : registry().contexts) {
    if (auto context = known.lock()) {
      alive.push_back(std::move(context));
    }
  }
  return alive;
}

contexts::DefaultContext::SharedPtr contexts::get_global_default_context()
{
  registry();  // outlives the context, which is made after it
  static const auto context = std::make_shared<DefaultContext>();
  return context;
}

}  // namespace rclcpp
