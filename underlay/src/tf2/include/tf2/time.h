#pragma once

#include <chrono>
#include <string>

#include "tf2/visibility_control.h"

namespace tf2
{

using Duration = std::chrono::nanoseconds;
using TimePoint = std::chrono::time_point<std::chrono::system_clock, Duration>;
using IDuration = std::chrono::duration<int, std::nano>;

/// Where a time is asked for, this means the latest one there is.
static const TimePoint TimePointZero{Duration::zero()};

TimePoint get_now();
Duration durationFromSec(double t_sec);
TimePoint timeFromSec(double t_sec);
double durationToSec(const Duration & input);
double timeToSec(const TimePoint & timepoint);

/// Seconds with six decimals.
std::string displayTimePoint(const TimePoint & stamp);

}  // namespace tf2
