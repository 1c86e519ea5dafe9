#include "cpp_package_with_a_library/sample_class.hpp"

#include <Eigen/Core>
#include <QString>

// TODO: define what the header declares. `QString("SampleClass(%1)").arg(number).toStdString()` makes a text,
// and the `sum()` of an `Eigen::Vector3d` adds up its three numbers.
