#pragma once

#include <string>
#include <vector>

#include "pluginlib/class_desc.hpp"

namespace pluginlib::detail
{

/// The classes in a file that describes plugins, whatever their base.
/// Throws InvalidXMLException if it cannot be read, and ClassLoaderException if a class lacks an attribute.
std::vector<ClassDesc> read_descriptions(const std::string & file);

}  // namespace pluginlib::detail
