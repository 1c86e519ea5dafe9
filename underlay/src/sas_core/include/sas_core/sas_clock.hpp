// The clock of a loop that runs at a fixed rate.

#pragma once

#include <array>
#include <atomic>
#include <chrono>

#include <sas_core/sas_statistics.hpp>

namespace sas
{

/// Call init() before the loop and update_and_sleep() once in it.
///
/// The loop goes on at init() + 1, 2, 3, ... sampling times: late rounds do not shift later ones. Where a
/// round takes longer than the sampling time, the moments that were missed are left out, and counted.
/// For one thread.
class Clock
{
public:
  enum class TimeType
  {
    Computational,      ///< from waking up to the next update_and_sleep()
    EffectiveSampling,  ///< from waking up to waking up
    Idle                ///< asleep in update_and_sleep()
  };

  using TimePoint = std::chrono::time_point<std::chrono::system_clock, std::chrono::nanoseconds>;

  /// Throws std::invalid_argument for a sampling time that is not positive.
  explicit Clock(const double & thread_sampling_time_sec, const bool & enable_statistics = true);
  Clock() = delete;
  Clock(const int &) = delete;  // NOLINT: Clock(1) would be a whole second, which is hardly meant
  Clock(const Clock &) = delete;
  Clock & operator=(const Clock &) = delete;

  /// Start counting now; figures of an earlier loop are forgotten.
  void init();

  /// Sleep until the next moment; starts the clock if nobody has.
  void update_and_sleep();

  /// Sleep for that long, or until *break_loops is true (looked at a hundred times per second).
  static void safe_sleep_seconds(const double & seconds, std::atomic_bool * break_loops);

  /// Sleep for that long, whatever happens.
  static void blocking_sleep_seconds(const double & seconds);

  /// When init() was called, and when update_and_sleep() woke up last.
  TimePoint get_initial_time() const;
  TimePoint get_last_update_time() const;

  /// Of the last round, in seconds; 0 before the first.
  double get_time(const TimeType & time_type) const;

  double get_desired_thread_sampling_time_sec() const;
  double get_effective_thread_sampling_time_sec() const;  ///< of the last round, in seconds
  double get_computation_time() const;                    ///< of the last round, in seconds
  double get_sleep_time() const;                          ///< of the last round, in seconds
  double get_elapsed_time_sec() const;                    ///< since init()
  long get_overrun_count() const;                         ///< moments that were missed since init()

  /// A figure in seconds over all rounds since init(); NaN before the first. Throws std::runtime_error for a
  /// clock that was told to take none.
  double get_statistics(const Statistics & statistics, const TimeType & time_type) const;

private:
  using Steady = std::chrono::steady_clock;

  struct Series
  {
    double last = 0.0;
    RunningStatistics statistics;
  };

  void record(TimeType time_type, Steady::duration duration);
  const Series & series(TimeType time_type) const;

  TimePoint on_the_wall(Steady::time_point moment) const;

  Steady::duration sampling_time_;
  bool enable_statistics_;
  bool started_ = false;
  Steady::time_point initial_;
  TimePoint initial_on_the_wall_;
  Steady::time_point deadline_;
  Steady::time_point woke_up_;
  long overrun_count_ = 0;
  std::array<Series, 3> series_;
};

}  // namespace sas
