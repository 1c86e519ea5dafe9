#include "joints.hpp"

#include <iostream>
#include <stdexcept>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "Tell me a joint and a cosine: ./bounds 2 0.5\n";
    return 2;
  }
  const std::vector<double> positions{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const std::size_t joint = std::stoul(argv[1]);
  const double cosine = std::stod(argv[2]);

  try {
    const double position = position_of(positions, joint);
    std::cout << "joint " << joint << ": " << position << '\n';
  } catch (const std::out_of_range&) {
    std::cout << "joint " << joint << ": out of range\n";
  }

  try {
    const double angle = angle_of(cosine);
    std::cout << "angle: " << angle << '\n';
  } catch (const std::domain_error&) {
    std::cout << "angle: not a number\n";
  }

  return 0;
}
