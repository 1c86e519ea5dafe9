// Says what dqrobotics and sas_conversions make of some numbers: a name and numbers, or words, in each line.

#include <cmath>
#include <functional>
#include <initializer_list>
#include <iomanip>
#include <iostream>
#include <string>

#include <rclcpp/rclcpp.hpp>
#include <sas_conversions/sas_conversions.hpp>

namespace
{

void say(const std::string & name, std::initializer_list<DQ> dqs)
{
  std::cout << name;
  for (const DQ & dq : dqs) {
    std::cout << " " << dq.q.transpose();
  }
  std::cout << "\n";
}

std::string what_of(const std::function<void()> & action)
{
  try {
    action();
    return "nothing";
  } catch (const std::range_error & error) {
    return error.what();
  }
}

void algebra(const DQ & x, const DQ & r, const DQ & t)
{
  const DQ y = x * (2.0 * r + i_ + E_ * t) - 0.5;
  say("parts", {P(y), D(y), Re(y), Im(y), conj(y), sharp(y)});
  say("products", {y * x, x * y, Ad(r, t), cross(t, r * i_), dot(t, j_ + 2 * k_)});
  say("sums", {y + x, y - x, -y, 1 + y, y - 2});
  say("difference", {3 - y, y});
  say("norms", {norm(y), inv(y), normalize(y), norm(E_)});
  say("pose", {translation(x), rotation(x), rotation_axis(x), DQ(rotation_angle(x)), rotation_axis(DQ(1))});
  say("powers", {log(x), exp(0.3 * log(x)), exp(E_ * t), pow(x, 2.5)});
  say("plus", {DQ(hamiplus8(y) * vec8(x)), DQ(haminus8(y) * vec8(x)), DQ(C8() * vec8(y))});
  say("four", {DQ(hamiplus4(y) * vec4(x)), DQ(haminus4(y) * vec4(x)), DQ(C4() * vec4(y))});
  say("vectors", {DQ(vec3(y)), DQ(vec4(y)), DQ(vec6(y)), DQ(vec8(y)), DQ(VectorXd::Constant(1, 5.0))});
  std::cout << "equal " << (x == x + 1e-13) << (x == x + 1e-11) << (x != y) << (DQ(2) == 2) << (y == 2) <<
    is_unit(x) << is_unit(y) << is_pure(t) << is_real(t) << is_quaternion(r) << is_quaternion(x) << "\n";
  std::cout << "text " << y << "|" << t << "|" << E_ << "|" << DQ(0) << "|" << DQ(-1.5) << "|" << -E_ << "\n";
  std::cout << "size " << what_of([] {DQ(VectorXd::Zero(2));}) << "\n";
  std::cout << "unit " << what_of([&] {translation(2 * x);}) << "\n";
  std::cout << "real " << what_of([&] {exp(x);}) << "\n";
}

void messages(const DQ & x, const DQ & r, const DQ & t)
{
  const auto point = sas::dq_to_geometry_msgs_point(t);
  const auto pose = sas::dq_to_geometry_msgs_pose(x);
  say("point", {DQ(0, point.x, point.y, point.z), sas::geometry_msgs_point_to_dq(point)});
  say("pose_message", {
      DQ(0, pose.position.x, pose.position.y, pose.position.z),
      DQ(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z),
      sas::geometry_msgs_pose_to_dq(pose)});
  auto quaternion = sas::dq_to_geometry_msgs_quaternion(r);
  quaternion.w *= 3.0;
  say("quaternion", {sas::geometry_msgs_quaternion_to_dq(quaternion)});
  DQ one, other;
  const auto wrench = sas::dq_to_geometry_msgs_wrench(t, r);
  sas::geometry_msgs_wrench_to_dq(wrench, one, other);
  say("wrench", {DQ(wrench.force.x, wrench.force.z, wrench.torque.y), one, other});
  const auto twist = sas::dq_to_geometry_msgs_twist(t, r);
  sas::geometry_msgs_twist_to_dq(twist, one, other);
  say("twist", {DQ(twist.linear.x, twist.linear.z, twist.angular.z), one, other});
  sas::geometry_msgs_wrench_stamped_to_dq(sas::dq_to_geometry_msgs_wrench_stamped(r, t), one, other);
  say("stamped", {
      one, other, sas::geometry_msgs_pose_stamped_to_dq(sas::dq_to_geometry_msgs_pose_stamped(x))});
  const auto stamped = sas::dq_to_geometry_msgs_point_stamped(t);
  say("stamped_point", {sas::geometry_msgs_point_stamped_to_dq(stamped)});
  std::cout << "age " << rclcpp::Clock().now().seconds() - rclcpp::Time(stamped.header.stamp).seconds() << "\n";
  std::cout << "number " << sas::std_msgs_float64_to_double(sas::double_to_std_msgs_float64(0.25)) << "\n";
  std::cout << "truth " << sas::std_msgs_bool_to_bool(sas::bool_to_std_msgs_bool(true)) <<
    sas::std_msgs_bool_to_bool(sas::bool_to_std_msgs_bool(false)) << "\n";
}

}  // namespace

int main()
{
  std::cout << std::setprecision(17);
  const DQ axis = (2 * i_ - 3 * j_ + 6 * k_) * (1.0 / 7.0);
  const DQ r = std::cos(0.4) + std::sin(0.4) * axis;
  const DQ t = 0.5 * i_ - 1.25 * j_ + 4 * k_;
  const DQ x = r + 0.5 * E_ * t * r;
  algebra(x, r, t);
  messages(x, r, t);
  return 0;
}
