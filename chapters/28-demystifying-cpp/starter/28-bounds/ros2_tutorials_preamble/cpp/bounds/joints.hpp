#pragma once

#include <cstddef>
#include <vector>

// Returns the position of a joint in radians. The first joint has number 0.
// Throws std::out_of_range if there is no such joint.
double position_of(const std::vector<double>& positions, std::size_t joint);

// Returns the angle in radians that has this cosine.
// Throws std::domain_error if there is no such angle.
double angle_of(double cosine);
