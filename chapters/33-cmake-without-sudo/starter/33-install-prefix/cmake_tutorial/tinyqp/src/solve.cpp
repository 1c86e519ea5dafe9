// With two variables, the solution is inside all the constraints, on the edge of one, or where two edges meet.
// There are only a few such points. The solver tries all of them and returns the best one that is allowed.

#include "lines.hpp"

#include <algorithm>
#include <cmath>

namespace tinyqp {

namespace {

Vector times(const std::array<double, 3>& h, const Vector& x) {
  return {h[0] * x[0] + h[1] * x[1], h[1] * x[0] + h[2] * x[1]};
}

double objective(const Problem& problem, const Vector& x) {
  return 0.5 * dot(x, times(problem.h, x)) + dot(problem.g, x);
}

Vector gradient(const Problem& problem, const Vector& x) {
  return sum(times(problem.h, x), 1.0, problem.g);
}

double determinant(const std::array<double, 3>& h) {
  return h[0] * h[2] - h[1] * h[1];
}

// Returns the largest number in H. Much smaller numbers count as zero.
double scale(const std::array<double, 3>& h) {
  return std::max({std::abs(h[0]), std::abs(h[1]), std::abs(h[2])});
}

bool is_singular(const std::array<double, 3>& h) {
  return determinant(h) <= tiny * scale(h) * scale(h);
}

bool is_convex(const Problem& problem) {
  const auto& h = problem.h;
  const double zero = tiny * scale(h);
  for (const double number : {h[0], h[1], h[2], problem.g[0], problem.g[1]}) {
    if (!std::isfinite(number)) {
      return false;
    }
  }
  return h[0] >= -zero && h[2] >= -zero && determinant(h) >= -zero * scale(h);
}

// Directions in which x' H x does not grow.
std::vector<Vector> flat_directions(const Problem& problem, const std::vector<Line>& lines) {
  const auto& h = problem.h;
  if (!is_singular(h)) {
    return {};
  }
  if (scale(h) > 0.0) {
    const Vector flat = h[0] >= h[2] ? Vector{-h[1], h[0]} : Vector{h[2], -h[1]};
    return {flat, {-flat[0], -flat[1]}};
  }
  std::vector<Vector> all{{-problem.g[0], -problem.g[1]}};
  for (const Line& line : lines) {
    const Vector along = line.direction();
    for (const double sign : {1.0, -1.0}) {
      all.push_back({sign * along[0], sign * along[1]});
      all.push_back({sign * line.a[0], sign * line.a[1]});
    }
  }
  return all;
}

bool is_unbounded(const Problem& problem, const std::vector<Constraint>& constraints,
                  const std::vector<Line>& lines) {
  const std::vector<Vector> flat = flat_directions(problem, lines);
  return std::any_of(flat.begin(), flat.end(), [&](const Vector& direction) {
    const double size = std::hypot(direction[0], direction[1]);
    const double slope = dot(problem.g, direction);
    return slope < -tiny * size * std::max(1.0, std::abs(slope)) && leads_away(constraints, direction);
  });
}

// Returns a point where the objective would be smallest without constraints.
Vector free_minimum(const Problem& problem) {
  const auto& [h11, h12, h22] = problem.h;
  const auto& [g1, g2] = problem.g;
  if (!is_singular(problem.h)) {
    const double size = determinant(problem.h);
    return {(-h22 * g1 + h12 * g2) / size, (h12 * g1 - h11 * g2) / size};
  }
  // H curves in only one direction, that of its larger column.
  const Vector steep = h11 >= h22 ? Vector{h11, h12} : Vector{h12, h22};
  const double curvature = dot(steep, times(problem.h, steep));
  return curvature > 0.0 ? sum({0.0, 0.0}, -dot(problem.g, steep) / curvature, steep) : Vector{0.0, 0.0};
}

Vector least_on(const Line& line, const Problem& problem) {
  const Vector direction = line.direction();
  const double curvature = dot(direction, times(problem.h, direction));
  if (curvature <= tiny * scale(problem.h)) {
    return line.point();
  }
  return sum(line.point(), -dot(direction, gradient(problem, line.point())) / curvature, direction);
}

std::vector<Vector> candidates(const Problem& problem, const std::vector<Line>& lines) {
  std::vector<Vector> all{free_minimum(problem)};
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    all.push_back(least_on(*line, problem));
    for (auto other = lines.begin(); other != line; ++other) {
      if (const auto corner = meeting(*line, *other)) {
        all.push_back(*corner);
      }
    }
  }
  return all;
}

}  // namespace

Solution solve(const Problem& problem) {
  Solution best;
  if (!is_convex(problem)) {
    best.status = Status::not_convex;
    return best;
  }
  const std::vector<Constraint> constraints = all_constraints(problem);
  const std::vector<Line> lines = edges(constraints);
  for (const Vector& x : candidates(problem, lines)) {
    const double value = objective(problem, x);
    if (satisfies(constraints, x) && (best.status != Status::solved || value < best.objective)) {
      best = {Status::solved, x, value};
    }
  }
  if (best.status == Status::solved && is_unbounded(problem, constraints, lines)) {
    best.status = Status::unbounded;
  }
  return best;
}

}  // namespace tinyqp
