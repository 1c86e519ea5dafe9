#include <tinyqp/tinyqp.hpp>

#include <iomanip>
#include <iostream>

int main() {
  tinyqp::Problem problem;
  problem.h = {1.0, 0.0, 0.5};
  problem.constraints.resize(1);
  problem.constraints[0].a = {1.0, 1.0};
  for (const bool is_first : {true, false}) {
    problem.g = is_first ? tinyqp::Vector{1.5, 1.0} : tinyqp::Vector{1.0, 1.5};
    problem.lower = is_first ? tinyqp::Vector{0.5, -2.0} : tinyqp::Vector{0.0, -1.0};
    problem.upper = is_first ? tinyqp::Vector{5.0, 2.0} : tinyqp::Vector{5.0, -0.5};
    problem.constraints[0].lower = is_first ? -1.0 : -2.0;
    problem.constraints[0].upper = is_first ? 2.0 : 1.0;
    const auto solution = tinyqp::solve(problem);
    std::cout << std::scientific << "x = (" << solution.x[0] << ", " << solution.x[1] << "), objective "
              << solution.objective << std::endl;
  }
}
