#pragma once

#include "class_loader/class_loader.hpp"

/// Makes `class_type` known by its name when the library is loaded. Once for each class, outside of any namespace,
/// with the namespaces in both names.
#define PLUGINLIB_EXPORT_CLASS(class_type, base_class_type) \
  CLASS_LOADER_REGISTER_CLASS(class_type, base_class_type)
