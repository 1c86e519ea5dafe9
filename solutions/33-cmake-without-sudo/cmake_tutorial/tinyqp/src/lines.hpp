#pragma once

#include "tinyqp/tinyqp.hpp"

#include <optional>
#include <vector>

namespace tinyqp {

// What counts as zero, for numbers of about one.
inline constexpr double tiny = 1e-9;

// All points with a' x = b; a has the length one.
struct Line {
  Vector a{};
  double b = 0.0;

  Vector direction() const;
  // The one that is nearest to the origin.
  Vector point() const;
};

double dot(const Vector& left, const Vector& right);

// left + factor * right
Vector sum(const Vector& left, double factor, const Vector& right);

// The box and the constraints alike.
std::vector<Constraint> all_constraints(const Problem& problem);

// The edges of all constraints; those at infinity, and those without a direction, have none.
std::vector<Line> edges(const std::vector<Constraint>& constraints);

// Where two lines meet; nothing if they are parallel.
std::optional<Vector> meeting(const Line& one, const Line& other);

bool satisfies(const std::vector<Constraint>& constraints, const Vector& x);

// Whether one may go on in this direction without end, as far as the constraints are concerned.
bool leads_away(const std::vector<Constraint>& constraints, const Vector& direction);

}  // namespace tinyqp
