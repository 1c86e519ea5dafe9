#include <tinyqp/tinyqp.hpp>

#include <iostream>

namespace {

void print_solution(const tinyqp::Problem& problem) {
  const tinyqp::Solution solution = tinyqp::solve(problem);
  std::cout << solution.x[0] << ' ' << solution.x[1] << ' ' << solution.objective << '\n';
}

}  // namespace

int main() {
  tinyqp::Problem first;
  first.h = {1.0, 0.0, 0.5};
  first.g = {1.5, 1.0};
  first.lower = {0.5, -2.0};
  first.upper = {5.0, 2.0};
  first.constraints = {{{1.0, 1.0}, -1.0, 2.0}};
  print_solution(first);

  tinyqp::Problem second = first;
  second.g = {1.0, 1.5};
  second.lower = {0.0, -1.0};
  second.upper = {5.0, -0.5};
  second.constraints = {{{1.0, 1.0}, -2.0, 1.0}};
  print_solution(second);

  return 0;
}
