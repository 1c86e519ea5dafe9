#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

inline double position_of(const std::vector<double>& positions, std::size_t joint) {
  return positions.at(joint);
}

inline double angle_of(double cosine) {
  const double angle = std::acos(cosine);
  return angle == angle ? angle : throw std::domain_error("not a number");
}
