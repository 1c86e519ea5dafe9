#include "joints.hpp"

#include <cstdio>
#include <cstdlib>

int main(int, char** argv) {
  const std::vector<double> positions{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const auto joint = static_cast<std::size_t>(std::strtoul(argv[1], nullptr, 10));
  try {
    std::printf("joint %zu: %g\n", joint, position_of(positions, joint));
  } catch (const std::exception&) {
    std::printf("joint %zu: out of range\n", joint);
  }
  double angle = std::numeric_limits<double>::quiet_NaN();
  try {
    angle = angle_of(std::strtod(argv[2], nullptr));
  } catch (const std::exception&) {
    std::puts("angle: not a number");
  }
  if (!std::isnan(angle)) {
    std::printf("angle: %.4f\n", angle);
  }
  return EXIT_SUCCESS;
}
