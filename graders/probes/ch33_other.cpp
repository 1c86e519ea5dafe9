// A library with the name and the functions of tinyqp, and with other answers: whoever prints these has asked
// this one.
#include <tinyqp/tinyqp.hpp>

namespace tinyqp {

Solution solve(const Problem& problem) {
  Solution solution;
  solution.status = Status::solved;
  solution.x = {7.0, 8.0 + problem.g[0]};
  solution.objective = 99.0;
  return solution;
}

}  // namespace tinyqp
