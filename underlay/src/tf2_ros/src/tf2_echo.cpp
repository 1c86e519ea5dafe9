// tf2_echo SOURCE TARGET [RATE]: prints, again and again, where one frame is in another one.

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace
{

constexpr char USAGE[] =
  R"(Usage: tf2_echo source_frame target_frame [echo_rate]

Prints what leads from coordinates in target_frame to those in source_frame: where target_frame is.
The rate is in Hz, 1 unless it is given.
)";

void print(const geometry_msgs::msg::TransformStamped & found)
{
  const auto & v = found.transform.translation;
  const auto & q = found.transform.rotation;
  const tf2::Matrix3x3 matrix(tf2::Quaternion(q.x, q.y, q.z, q.w));
  double roll, pitch, yaw;
  matrix.getRPY(roll, pitch, yaw);
  constexpr double DEGREES = TF2SIMD_DEGS_PER_RAD;
  std::printf("At time %d.%u\n", found.header.stamp.sec, found.header.stamp.nanosec);
  std::printf("- Translation: [%.3f, %.3f, %.3f]\n", v.x, v.y, v.z);
  std::printf("- Rotation: in Quaternion [%.3f, %.3f, %.3f, %.3f]\n", q.x, q.y, q.z, q.w);
  std::printf("- Rotation: in RPY (radian) [%.3f, %.3f, %.3f]\n", roll, pitch, yaw);
  std::printf(
    "- Rotation: in RPY (degree) [%.3f, %.3f, %.3f]\n", roll * DEGREES, pitch * DEGREES, yaw * DEGREES);
  std::printf("- Matrix:\n");
  const double origin[] = {v.x, v.y, v.z};
  for (int i = 0; i < 3; ++i) {
    std::printf(" %6.3f %6.3f %6.3f %6.3f\n", matrix[i][0], matrix[i][1], matrix[i][2], origin[i]);
  }
  std::printf(" %6.3f %6.3f %6.3f %6.3f\n", 0.0, 0.0, 0.0, 1.0);
}

void echo(const std::string & source, const std::string & target, double hertz)
{
  rclcpp::Rate rate(hertz);
  const auto node = std::make_shared<rclcpp::Node>("tf2_echo");
  tf2_ros::Buffer buffer(node->get_clock());
  const tf2_ros::TransformListener listener(buffer);
  std::string error;
  while (rclcpp::ok() && !buffer.canTransform(source, target, tf2::TimePointZero, &error)) {
    RCLCPP_INFO_THROTTLE(
      node->get_logger(), *node->get_clock(), 1000, "Waiting for transform %s ->  %s: %s", source.c_str(),
      target.c_str(), error.c_str());
    rate.sleep();
  }
  while (rclcpp::ok()) {
    try {
      print(buffer.lookupTransform(source, target, tf2::TimePointZero));
    } catch (const tf2::TransformException & exception) {
      std::printf("Failure at %.3f\n", node->now().seconds());
      std::printf("Exception thrown:%s\n", exception.what());
      std::printf("The current list of frames is:\n%s\n", buffer.allFramesAsString().c_str());
    }
    std::fflush(stdout);
    rate.sleep();
  }
}

}  // namespace

int main(int argc, char ** argv)
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (words.size() != 3 && words.size() != 4) {
    std::puts(USAGE);
    return 1;
  }
  double rate = 1;
  if (words.size() == 4) {
    std::size_t end = 0;
    try {
      rate = std::stof(words[3], &end);
    } catch (const std::logic_error &) {
      // `end` stays 0.
    }
    if (end != words[3].size()) {
      std::fprintf(
        stderr, "Failed to convert rate argument '%s' to a floating-point number\n", words[3].c_str());
      return end == 0 ? 2 : 3;
    }
  }
  echo(words[1], words[2], rate);
  return 0;
}
