#include "tf2/time.h"

#include <cmath>
#include <cstdio>

namespace tf2
{

TimePoint get_now() {return std::chrono::system_clock::now();}

Duration durationFromSec(double t_sec)
{
  // Apart, for a double has no digits left for the nanoseconds of today's date.
  const double seconds = std::floor(t_sec);
  return std::chrono::seconds(static_cast<std::int64_t>(seconds)) +
         std::chrono::nanoseconds(std::llround((t_sec - seconds) * 1e9));
}

TimePoint timeFromSec(double t_sec) {return TimePoint(durationFromSec(t_sec));}

double durationToSec(const Duration & input)
{
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(input);
  return static_cast<double>(seconds.count()) + 1e-9 * static_cast<double>((input - seconds).count());
}

double timeToSec(const TimePoint & timepoint) {return durationToSec(timepoint.time_since_epoch());}

std::string displayTimePoint(const TimePoint & stamp)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.6f", timeToSec(stamp));
  return text;
}

}  // namespace tf2
