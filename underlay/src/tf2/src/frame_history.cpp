#include "frame_history.hpp"

#include <algorithm>

namespace tf2
{

namespace
{

Placement between(const Placement & older, const Placement & newer, TimePoint time)
{
  if (older.parent != newer.parent) {
    return older;
  }
  const double ratio = static_cast<double>((time - older.stamp).count()) /
    static_cast<double>((newer.stamp - older.stamp).count());
  Placement placement = older;
  placement.translation.setInterpolate3(older.translation, newer.translation, ratio);
  placement.rotation = older.rotation.slerp(newer.rotation, ratio);
  return placement;
}

bool is_before(TimePoint time, const Placement & placement) {return time < placement.stamp;}

}  // namespace

TimePoint FrameHistory::latest() const
{
  return is_static_ || placements_.empty() ? TimePointZero : placements_.back().stamp;
}

TimePoint FrameHistory::oldest() const
{
  return is_static_ || placements_.empty() ? TimePointZero : placements_.front().stamp;
}

bool FrameHistory::insert(const Placement & placement)
{
  if (is_static_) {
    placements_.assign(1, placement);
    return true;
  }
  while (!placements_.empty() && placements_.front().stamp < latest() - kept_) {
    placements_.pop_front();
  }
  if (!placements_.empty() && placement.stamp < latest() - kept_) {
    return false;
  }
  const auto place =
    std::upper_bound(placements_.begin(), placements_.end(), placement.stamp, is_before);
  for (auto same = place; same != placements_.begin() && (--same)->stamp == placement.stamp;) {
    if (*same == placement) {
      return true;
    }
  }
  placements_.insert(place, placement);
  return true;
}

std::optional<Placement> FrameHistory::at(TimePoint time, Gap & gap) const
{
  if (is_static_ || (time == TimePointZero && !placements_.empty())) {
    return placements_.back();
  }
  if (const auto found = gap_at(time)) {
    gap = *found;
    return std::nullopt;
  }
  const auto newer = std::upper_bound(placements_.begin(), placements_.end(), time, is_before);
  return newer == placements_.end() ? placements_.back() : between(*(newer - 1), *newer, time);
}

std::optional<Gap> FrameHistory::gap_at(TimePoint time) const
{
  const auto text = [time](const char * before, const char * between, TimePoint there, const char * after = "") {
      return before + displayTimePoint(time) + between + displayTimePoint(there) + after;
    };
  if (placements_.empty()) {
    return Gap();
  }
  if (placements_.size() == 1 && time != latest()) {
    return Gap{
      TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR,
      text("Lookup would require extrapolation at time ", ", but only time ", latest(), " is in the buffer")};
  }
  if (time > latest()) {
    return Gap{
      TF2Error::TF2_FORWARD_EXTRAPOLATION_ERROR,
      text(
        "Lookup would require extrapolation into the future.  Requested time ",
        " but the latest data is at time ", latest())};
  }
  if (time < oldest()) {
    return Gap{
      TF2Error::TF2_BACKWARD_EXTRAPOLATION_ERROR,
      text(
        "Lookup would require extrapolation into the past.  Requested time ",
        " but the earliest data is at time ", oldest())};
  }
  return std::nullopt;
}

void FrameHistory::clear()
{
  if (!is_static_) {
    placements_.clear();
  }
}

}  // namespace tf2
