#include "sensors.hpp"

#include <cmath>
#include <stdexcept>

double range_of(const std::vector<double>& ranges, std::size_t sensor) {
  return ranges.at(sensor);
}

double tilt_of(double cosine) {
  const double tilt = std::acos(cosine);
  if (std::isnan(tilt)) {
    throw std::domain_error("no angle has this cosine");
  }
  return tilt;
}
