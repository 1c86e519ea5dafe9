#include "joints.hpp"

#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "Give a joint and a cosine: ./bounds 2 0.5\n";
    return 2;
  }
  const std::vector<double> positions{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const std::size_t joint = std::stoul(argv[1]);
  const double cosine = std::stod(argv[2]);

  // TODO 3: catch the exception of position_of, and print "joint 9: out of range".
  const double position = position_of(positions, joint);
  std::cout << "joint " << joint << ": " << position << '\n';

  // TODO 4: catch the exception of angle_of, and print "angle: not a number".
  const double angle = angle_of(cosine);
  std::cout << "angle: " << angle << '\n';

  return 0;
}
