#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "frame_history.hpp"
#include "tf2/LinearMath/Transform.h"

namespace tf2
{

/// All frames, and who is whose parent. It knows no threads.
class FrameTree
{
public:
  explicit FrameTree(Duration kept);

  /// 0 if it is not known.
  FrameId find(const std::string & name) const;
  FrameId find_or_add(const std::string & name);
  std::vector<std::string> names() const;

  /// False if that is so old that it is not kept.
  bool insert(FrameId child, const Placement & placement, const std::string & authority, bool is_static);
  /// Forgets where frames are, but not their names.
  void clear();

  struct Found
  {
    Transform transform;
    TimePoint stamp;
  };
  /// What leads from coordinates in `source` to those in `target`. Throws TransformException.
  Found lookup(FrameId target, FrameId source, TimePoint time) const;

  /// The latest time for which the way between them is known; zero if it is static. Throws as above.
  TimePoint latest_common_time(FrameId target, FrameId source) const;

  /// 0 if it is not known for that time.
  FrameId parent(FrameId frame, TimePoint time) const;
  const std::string & name(FrameId frame) const {return frames_.at(frame).name;}

  std::string as_string() const;
  /// With how old the data is, unless `now` is zero.
  std::string as_yaml(TimePoint now) const;

private:
  struct Frame
  {
    std::string name;
    std::optional<FrameHistory> history;  // none for a root
    std::string authority;
  };

  /// A frame on the way up from another one, and the way to it.
  struct Step
  {
    FrameId frame;
    Quaternion rotation;
    Vector3 translation;
  };

  static Step above(const Step & step, const Placement & placement);
  std::vector<Step> way_up(
    FrameId source, FrameId target, TimePoint time, std::optional<Gap> & gap) const;
  void check_depth(std::size_t depth) const;
  [[noreturn]] void throw_gap(const Gap & gap, FrameId target, FrameId source) const;
  [[noreturn]] void throw_unconnected(FrameId target, FrameId source) const;

  Duration kept_;
  std::vector<Frame> frames_;
  std::unordered_map<std::string, FrameId> ids_;
};

}  // namespace tf2
