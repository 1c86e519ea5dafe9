#pragma once

#include "class_loader/registry.hpp"

#define CLASS_LOADER_DO_JOIN(first, second) first ## second
#define CLASS_LOADER_JOIN(first, second) CLASS_LOADER_DO_JOIN(first, second)

/// Makes `Derived` known by its name when the library is loaded. Once for each class, outside of any namespace.
#define CLASS_LOADER_REGISTER_CLASS(Derived, Base) \
  static const bool CLASS_LOADER_JOIN(class_loader_registered_, __COUNTER__) = \
    class_loader::detail::register_class<Derived, Base>(#Derived);
