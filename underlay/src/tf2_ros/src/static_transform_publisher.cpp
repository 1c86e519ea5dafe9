// static_transform_publisher [--x X] ...: tells where one frame is, until it is stopped.

#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2_ros/static_transform_broadcaster.h"

namespace
{

constexpr char USAGE[] =
  R"(usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW])"
  R"( [--roll ROLL] [--pitch PITCH] [--yaw YAW] --frame-id FRAME_ID --child-frame-id CHILD_FRAME_ID

Tells other nodes, once and for all, where a frame is in another one. What is not given is zero: the two
frames are the same then.

required arguments:
  --frame-id FRAME_ID parent frame
  --child-frame-id CHILD_FRAME_ID child frame id

optional arguments:
  --x X                 x component of translation, in meters
  --y Y                 y component of translation
  --z Z                 z component of translation
  --qx QX               x component of quaternion rotation
  --qy QY               y component of quaternion rotation
  --qz QZ               z component of quaternion rotation
  --qw QW               w component of quaternion rotation
  --roll ROLL           roll component Euler rotation, in radians
  --pitch PITCH         pitch component Euler rotation
  --yaw YAW             yaw component Euler rotation
)";

/// What is wrong with the command line.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

double number(const std::string & name, const std::string & text)
{
  try {
    return std::stod(text);
  } catch (const std::logic_error &) {
    throw UsageError("Failed to parse " + name + " argument as float");
  }
}

/// What is given by name, and what is given without one.
class Words
{
public:
  /// Without the name of the program.
  explicit Words(const std::vector<std::string> & words)
  {
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i] == "--help" || words[i] == "-h") {
        wants_help = true;
      } else if (!is_option(words[i])) {
        plain.push_back(words[i]);
      } else if (i + 1 == words.size()) {
        throw UsageError("Not enough arguments for " + words[i]);
      } else {
        given_[words[i]] = words[i + 1];
        ++i;
      }
    }
  }

  bool has_any(const std::vector<std::string> & names) const
  {
    for (const auto & name : names) {
      if (given_.count(name)) {
        return true;
      }
    }
    return false;
  }
  std::string text(const std::string & name) const {return given_.count(name) ? given_.at(name) : "";}
  double value(const std::string & name, double otherwise = 0) const
  {
    return given_.count(name) ? number(name, given_.at(name)) : otherwise;
  }

  bool wants_help = false;
  std::vector<std::string> plain;

private:
  static bool is_option(const std::string & word)
  {
    for (const char * name : {
        "--x", "--y", "--z", "--qx", "--qy", "--qz", "--qw", "--roll", "--pitch", "--yaw", "--frame-id",
        "--child-frame-id"})
    {
      if (word == name) {
        return true;
      }
    }
    return false;
  }

  std::map<std::string, std::string> given_;
};

struct Place
{
  double x, y, z;
  tf2::Quaternion rotation;
  std::string parent, child;
};

Place by_name(const Words & words)
{
  const bool by_angles = words.has_any({"--roll", "--pitch", "--yaw"});
  if (by_angles && words.has_any({"--qx", "--qy", "--qz", "--qw"})) {
    throw UsageError("Cannot specify both quaternion and Euler rotations");
  }
  tf2::Quaternion rotation(
    words.value("--qx"), words.value("--qy"), words.value("--qz"), words.value("--qw", 1));
  if (by_angles) {
    rotation.setRPY(words.value("--roll"), words.value("--pitch"), words.value("--yaw"));
  }
  return {
    words.value("--x"), words.value("--y"), words.value("--z"), rotation, words.text("--frame-id"),
    words.text("--child-frame-id")};
}

/// x y z yaw pitch roll parent child, or x y z qx qy qz qw parent child
Place by_order(const Words & words)
{
  const auto & plain = words.plain;
  RCLCPP_WARN(
    rclcpp::get_logger(""), "Old-style arguments are deprecated; see --help for new-style arguments");
  if (words.has_any({"--x", "--y", "--z", "--qx", "--qy", "--qz", "--qw", "--frame-id", "--child-frame-id"})) {
    throw UsageError("Cannot specify both new-style (flags) and old-style (arguments)");
  }
  static const std::vector<std::string> angles{"x", "y", "z", "yaw", "pitch", "roll"};
  static const std::vector<std::string> quaternion{"x", "y", "z", "qx", "qy", "qz", "qw"};
  const auto & names = plain.size() == 8 ? angles : quaternion;
  std::vector<double> values;
  for (std::size_t i = 0; i < names.size(); ++i) {
    values.push_back(number(names[i], plain[i]));
  }
  tf2::Quaternion rotation;
  if (plain.size() == 8) {
    rotation.setRPY(values[5], values[4], values[3]);
  } else {
    rotation = {values[3], values[4], values[5], values[6]};
  }
  return {values[0], values[1], values[2], rotation, plain[plain.size() - 2], plain.back()};
}

Place place_of(const Words & words)
{
  const auto plain = words.plain.size();
  if (plain != 0 && plain != 8 && plain != 9) {
    throw UsageError("Extra unparsed arguments on command-line");
  }
  Place place = plain ? by_order(words) : by_name(words);
  if (place.parent.empty()) {
    throw UsageError("Frame id must not be empty");
  }
  if (place.child.empty()) {
    throw UsageError("Child frame id must not be empty");
  }
  return place;
}

std::string unique_name()
{
  constexpr char CHARACTERS[] = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> pick(0, sizeof CHARACTERS - 2);
  std::string name = "static_transform_publisher_";
  for (int i = 0; i < 16; ++i) {
    name += CHARACTERS[pick(random)];
  }
  return name;
}

void tell(const Place & place)
{
  const auto node = std::make_shared<rclcpp::Node>(unique_name());
  if (place.parent == place.child) {
    RCLCPP_ERROR(
      node->get_logger(), "cannot publish static transform from '%s' to '%s', exiting",
      place.parent.c_str(), place.child.c_str());
    throw std::runtime_error("child_frame_id cannot equal frame_id");
  }
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp = node->now();
  transform.header.frame_id = place.parent;
  transform.child_frame_id = place.child;
  transform.transform.translation.x = place.x;
  transform.transform.translation.y = place.y;
  transform.transform.translation.z = place.z;
  transform.transform.rotation.x = place.rotation.x();
  transform.transform.rotation.y = place.rotation.y();
  transform.transform.rotation.z = place.rotation.z();
  transform.transform.rotation.w = place.rotation.w();
  tf2_ros::StaticTransformBroadcaster broadcaster(node);
  broadcaster.sendTransform(transform);
  RCLCPP_INFO(
    node->get_logger(),
    "Spinning until stopped - publishing transform\ntranslation: ('%lf', '%lf', '%lf')\n"
    "rotation: ('%lf', '%lf', '%lf', '%lf')\nfrom '%s' to '%s'",
    place.x, place.y, place.z, place.rotation.x(), place.rotation.y(), place.rotation.z(),
    place.rotation.w(), place.parent.c_str(), place.child.c_str());
  rclcpp::spin(node);
}

}  // namespace

int main(int argc, char ** argv)
{
  try {
    const Words words(rclcpp::init_and_remove_ros_arguments(argc, argv));
    if (words.wants_help) {
      std::puts(USAGE);
      return 0;
    }
    tell(place_of(words));
  } catch (const UsageError & error) {
    RCLCPP_ERROR(rclcpp::get_logger(""), "error parsing command line arguments: %s", error.what());
    std::puts(USAGE);
    return 1;
  }
  rclcpp::shutdown();
  return 0;
}
