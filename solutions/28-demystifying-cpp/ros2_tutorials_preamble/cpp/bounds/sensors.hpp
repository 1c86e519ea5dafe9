#pragma once

#include <cstddef>
#include <vector>

// Returns the range that a sensor measured, in meters. The first sensor has number 0.
// Throws std::out_of_range if there is no such sensor.
double range_of(const std::vector<double>& ranges, std::size_t sensor);

// Returns the rover's tilt in radians: the angle that has this cosine.
// Throws std::domain_error if there is no such angle.
double tilt_of(double cosine);
