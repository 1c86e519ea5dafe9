#include "joints.hpp"

#include <cmath>

double position_of(const std::vector<double>& positions, std::size_t joint) {
  // TODO 1: throw std::out_of_range if there is no such joint.
  return positions[joint];
}

double angle_of(double cosine) {
  // TODO 2: throw std::domain_error if the result is not a number.
  return std::acos(cosine);
}
