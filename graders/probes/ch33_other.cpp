// tinyqp with other answers, which nobody can know without asking it: the solution, moved by AWAY (from 0 to 1)
// towards that of the same problem with another g, (G1, G2). It satisfies all bounds, too. The compiler's command
// line has the three numbers, which are drawn each time.
#define solve really_solve
#include "src/lines.cpp"
#include "src/solve.cpp"
#undef solve

#include <cstdio>

namespace tinyqp {

Solution solve(const Problem& problem) {
  Problem turned = problem;
  turned.g = {G1, G2};
  Solution solution = really_solve(problem);
  const Solution other = really_solve(turned);
  if (solution.status != Status::solved || other.status != Status::solved) {
    return solution;
  }
  Vector& x = solution.x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += AWAY * (other.x[i] - x[i]);
  }
  const auto& h = problem.h;
  solution.objective = 0.5 * (h[0] * x[0] * x[0] + h[2] * x[1] * x[1]) + h[1] * x[0] * x[1] + dot(problem.g, x);
  return solution;
}

}  // namespace tinyqp

// The `main` of a program that prints these answers to the task's two problems.
extern "C" int print_answers() {
  tinyqp::Problem first;
  first.h = {1.0, 0.0, 0.5};
  first.g = {1.5, 1.0};
  first.lower = {0.5, -2.0};
  first.upper = {5.0, 2.0};
  first.constraints = {{{1.0, 1.0}, -1.0, 2.0}};
  tinyqp::Problem second = first;
  second.g = {1.0, 1.5};
  second.lower = {0.0, -1.0};
  second.upper = {5.0, -0.5};
  second.constraints = {{{1.0, 1.0}, -2.0, 1.0}};
  for (const auto& problem : {first, second}) {
    const tinyqp::Solution solution = tinyqp::solve(problem);
    std::printf("%.6f %.6f %.6f\n", solution.x[0], solution.x[1], solution.objective);
  }
  return 0;
}
