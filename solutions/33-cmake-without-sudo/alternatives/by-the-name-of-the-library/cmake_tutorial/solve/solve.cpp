#include "tinyqp/tinyqp.hpp"

#include <cstdio>

int main() {
  const tinyqp::Problem problems[] = {
      {{1, 0, 0.5}, {1.5, 1}, {0.5, -2}, {5, 2}, {{{1, 1}, -1, 2}}},
      {{1, 0, 0.5}, {1, 1.5}, {0, -1}, {5, -0.5}, {{{1, 1}, -2, 1}}},
  };
  std::puts("Two quadratic programs:");
  for (const auto& problem : problems) {
    const auto [status, x, objective] = tinyqp::solve(problem);
    std::printf("x1 = %.4f, x2 = %.4f, objective = %.5f\n", x[0], x[1], objective);
  }
}
