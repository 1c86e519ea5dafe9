#include <sas_core/sas_clock.hpp>

#include <time.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>

namespace
{

using Steady = std::chrono::steady_clock;

// Awake this often, somebody who wants to end a program hardly notices the wait.
constexpr auto patience = std::chrono::milliseconds(10);

double in_seconds(Steady::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// Nothing for what is not positive, or no number.
Steady::duration from_seconds(double seconds)
{
  constexpr double longest = 1e9;  // thirty years; much more is not a duration anymore
  const std::chrono::duration<double> bounded(seconds > 0.0 ? std::min(seconds, longest) : 0.0);
  return std::chrono::duration_cast<Steady::duration>(bounded);
}

Steady::duration valid_sampling_time(double seconds)
{
  const auto duration = from_seconds(seconds);
  if (duration == Steady::duration::zero()) {
    throw std::invalid_argument(
      "sas::Clock: the sampling time must be positive, in seconds; it is " + std::to_string(seconds) + ".");
  }
  return duration;
}

// The system sleeps until that moment itself: computing how long would lose the time that computing takes.
void sleep_until(Steady::time_point moment)
{
  const auto since_start = std::chrono::duration_cast<std::chrono::nanoseconds>(moment.time_since_epoch());
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since_start);
  timespec deadline{};
  deadline.tv_sec = seconds.count();
  deadline.tv_nsec = (since_start - seconds).count();
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

}  // namespace

namespace sas
{

Clock::Clock(const double & thread_sampling_time_sec, const bool & enable_statistics)
: sampling_time_(valid_sampling_time(thread_sampling_time_sec)), enable_statistics_(enable_statistics)
{
}

void Clock::init()
{
  initial_ = Steady::now();
  initial_on_the_wall_ = std::chrono::system_clock::now();
  deadline_ = initial_;
  woke_up_ = initial_;
  overrun_count_ = 0;
  series_ = {};
  started_ = true;
}

void Clock::update_and_sleep()
{
  if (!started_) {
    init();
  }
  const auto done = Steady::now();
  const auto before = woke_up_;
  deadline_ += sampling_time_;
  if (deadline_ <= done) {
    const auto missed = (done - deadline_) / sampling_time_ + 1;
    overrun_count_ += static_cast<long>(missed);
    deadline_ += missed * sampling_time_;
  }
  sleep_until(deadline_);
  woke_up_ = Steady::now();
  record(TimeType::Computational, done - before);
  record(TimeType::Idle, woke_up_ - done);
  record(TimeType::EffectiveSampling, woke_up_ - before);
}

void Clock::safe_sleep_seconds(const double & seconds, std::atomic_bool * break_loops)
{
  const auto end = Steady::now() + from_seconds(seconds);
  for (auto now = Steady::now(); now < end; now = Steady::now()) {
    if (break_loops != nullptr && *break_loops) {
      return;
    }
    sleep_until(std::min<Steady::time_point>(now + patience, end));
  }
}

void Clock::blocking_sleep_seconds(const double & seconds)
{
  safe_sleep_seconds(seconds, nullptr);
}

Clock::TimePoint Clock::get_initial_time() const
{
  return initial_on_the_wall_;
}

Clock::TimePoint Clock::get_last_update_time() const
{
  return on_the_wall(woke_up_);
}

double Clock::get_time(const TimeType & time_type) const
{
  return series(time_type).last;
}

double Clock::get_desired_thread_sampling_time_sec() const
{
  return in_seconds(sampling_time_);
}

double Clock::get_effective_thread_sampling_time_sec() const
{
  return get_time(TimeType::EffectiveSampling);
}

double Clock::get_computation_time() const
{
  return get_time(TimeType::Computational);
}

double Clock::get_sleep_time() const
{
  return get_time(TimeType::Idle);
}

double Clock::get_elapsed_time_sec() const
{
  return started_ ? in_seconds(Steady::now() - initial_) : 0.0;
}

long Clock::get_overrun_count() const
{
  return overrun_count_;
}

double Clock::get_statistics(const Statistics & statistics, const TimeType & time_type) const
{
  if (!enable_statistics_) {
    throw std::runtime_error("sas::Clock: this clock was made with enable_statistics = false.");
  }
  return series(time_type).statistics.get(statistics);
}

void Clock::record(TimeType time_type, Steady::duration duration)
{
  Series & one = series_.at(static_cast<std::size_t>(time_type));
  one.last = in_seconds(duration);
  if (enable_statistics_) {
    one.statistics.add(one.last);
  }
}

/// As if the wall's clock had not been set since the beginning.
Clock::TimePoint Clock::on_the_wall(Steady::time_point moment) const
{
  return initial_on_the_wall_ + std::chrono::duration_cast<std::chrono::nanoseconds>(moment - initial_);
}

const Clock::Series & Clock::series(TimeType time_type) const
{
  return series_.at(static_cast<std::size_t>(time_type));
}

}  // namespace sas
