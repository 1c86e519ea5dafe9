#include <iostream>

#include "two_problems.hpp"

using namespace std;

int main()
{
  for (auto & problem : {first_problem(), second_problem()})
  {
    auto solution = tinyqp::solve(problem);
    if (solution.status != tinyqp::Status::solved)
    {
      cerr << "not solved" << endl;
      return 1;
    }
    cout << "x1: " << solution.x[0] << "\tx2: " << solution.x[1] << "\tobjective: " << solution.objective << endl;
  }
}
