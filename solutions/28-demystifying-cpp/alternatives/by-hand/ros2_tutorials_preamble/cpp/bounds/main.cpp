#include "joints.hpp"

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

void print_position(std::size_t joint) try {
  const std::vector<double> positions{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const double position = position_of(positions, joint);
  std::cout << "joint " << joint << ": " << position << std::endl;
} catch (const std::logic_error&) {
  std::cout << "joint " << joint << ": out of range" << std::endl;
}

void print_angle(double cosine) try {
  const double angle = angle_of(cosine);
  std::cout << "angle: " << angle << std::endl;
} catch (...) {
  std::cout << "angle: not a number" << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    return 2;
  }
  print_position(static_cast<std::size_t>(std::stoi(argv[1])));
  print_angle(std::atof(argv[2]));
}
