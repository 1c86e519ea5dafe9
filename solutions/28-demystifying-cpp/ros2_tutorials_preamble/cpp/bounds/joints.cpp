#include "joints.hpp"

#include <cmath>
#include <stdexcept>

double position_of(const std::vector<double>& positions, std::size_t joint) {
  return positions.at(joint);
}

double angle_of(double cosine) {
  const double angle = std::acos(cosine);
  if (std::isnan(angle)) {
    throw std::domain_error("no angle has this cosine");
  }
  return angle;
}
