// Solves a few quadratic programs with the learner's installed library.
#include "ask.hpp"

#include <tinyqp/tinyqp.hpp>

#include <vector>

namespace {

std::vector<double> solved(const tinyqp::Problem& problem) {
  const tinyqp::Solution solution = tinyqp::solve(problem);
  return {solution.status == tinyqp::Status::solved ? 1.0 : 0.0, solution.x[0], solution.x[1],
          solution.objective};
}

}  // namespace

int main() {
  tinyqp::Problem inside;
  inside.h = {2.0, 0.0, 4.0};
  inside.g = {-2.0, 4.0};
  ask("inside", [&] { return solved(inside); });

  tinyqp::Problem corner = inside;
  corner.lower = {2.0, 0.0};
  corner.upper = {3.0, 5.0};
  ask("corner", [&] { return solved(corner); });

  tinyqp::Problem edge = inside;
  edge.constraints = {{{1.0, 1.0}, 3.0, tinyqp::infinity}};
  ask("edge", [&] { return solved(edge); });
  done();
  return 0;
}
