#include "joints.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace {

class NoSuchJoint : public std::out_of_range {
public:
  explicit NoSuchJoint(std::size_t joint) : std::out_of_range("no joint " + std::to_string(joint)) {}
};

}  // namespace

double position_of(const std::vector<double>& positions, std::size_t joint) {
  if (joint >= positions.size()) {
    throw NoSuchJoint(joint);
  }
  return positions[joint];
}

double angle_of(double cosine) {
  if (!(cosine >= -1.0 && cosine <= 1.0)) {
    throw std::domain_error("a cosine is between -1 and 1");
  }
  return std::acos(cosine);
}
