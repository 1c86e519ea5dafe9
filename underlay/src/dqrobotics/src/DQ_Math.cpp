#include <dqrobotics/utils/DQ_Math.h>

namespace
{

constexpr double pi = 3.14159265358979323846;

}  // namespace

namespace DQ_robotics
{

double deg2rad(const double & degrees)
{
  return degrees * (pi / 180.0);
}

double rad2deg(const double & radians)
{
  return radians * (180.0 / pi);
}

Eigen::VectorXd deg2rad(const Eigen::VectorXd & degrees)
{
  return degrees * (pi / 180.0);
}

Eigen::VectorXd rad2deg(const Eigen::VectorXd & radians)
{
  return radians * (180.0 / pi);
}

}  // namespace DQ_robotics
