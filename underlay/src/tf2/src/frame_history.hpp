#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Vector3.h"
#include "tf2/exceptions.h"
#include "tf2/time.h"

namespace tf2
{

/// The number of a frame; 0 is none.
using FrameId = std::uint32_t;

/// Where a frame is in its parent, and when.
struct Placement
{
  TimePoint stamp;
  Quaternion rotation;
  Vector3 translation;
  FrameId parent = 0;

  bool operator==(const Placement & other) const
  {
    return stamp == other.stamp && rotation == other.rotation && translation == other.translation &&
           parent == other.parent;
  }
};

/// Why there is no placement for a time.
struct Gap
{
  TF2Error error = TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR;
  std::string text;
};

/// Where one frame was for a while, or, if it is static, where it is at all times.
class FrameHistory
{
public:
  FrameHistory(bool is_static, Duration kept) : is_static_(is_static), kept_(kept) {}

  bool is_static() const {return is_static_;}
  std::size_t size() const {return placements_.size();}
  /// Of static frames zero, as where there is nothing.
  TimePoint latest() const;
  TimePoint oldest() const;
  FrameId latest_parent() const {return placements_.empty() ? 0 : placements_.back().parent;}

  /// False if that is so old that it is not kept.
  bool insert(const Placement & placement);
  /// Between two that are known, it is interpolated. At TimePointZero it is the latest.
  std::optional<Placement> at(TimePoint time, Gap & gap) const;
  /// Static frames stay.
  void clear();

private:
  std::optional<Gap> gap_at(TimePoint time) const;

  bool is_static_;
  Duration kept_;
  std::deque<Placement> placements_;  // the oldest one first
};

}  // namespace tf2
