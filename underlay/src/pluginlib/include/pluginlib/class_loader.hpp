#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pluginlib/detail/plugin_loader.hpp"
#include "pluginlib/exceptions.hpp"

namespace pluginlib
{

template<typename T>
using UniquePtr = class_loader::ClassLoader::UniquePtr<T>;

/// Makes objects of classes with the base `T` that packages of the environment offer. Its objects may outlive it.
template<class T>
class ClassLoader : public detail::PluginLoader
{
public:
  /// `package` is that of the base class, and `base_class` the full name of `T`. Classes are described by the
  /// files of `plugin_xml_paths`, or else by those that packages have registered in the ament index.
  /// Throws ClassLoaderException if there is no such package, or a file describes a class incompletely.
  ClassLoader(
    std::string package, std::string base_class, std::string attrib_name = "plugin",
    std::vector<std::string> plugin_xml_paths = {})
  : PluginLoader(
      std::move(package), std::move(base_class), std::move(attrib_name), std::move(plugin_xml_paths))
  {
  }

  // These load the library of the class if it is not loaded yet.
  // They throw LibraryLoadException and CreateClassException.
  std::shared_ptr<T> createSharedInstance(const std::string & lookup_name)
  {
    return createUniqueInstance(lookup_name);
  }
  UniquePtr<T> createUniqueInstance(const std::string & lookup_name)
  {
    return library_with(lookup_name, true).template createUniqueInstance<T>(getClassType(lookup_name));
  }
  /// To be deleted by the caller.
  T * createUnmanagedInstance(const std::string & lookup_name)
  {
    return library_with(lookup_name, true).template createUnmanagedInstance<T>(getClassType(lookup_name));
  }
  [[deprecated("use createSharedInstance or createUnmanagedInstance")]]
  T * createClassInstance(const std::string & lookup_name, bool auto_load = true)
  {
    return library_with(lookup_name, auto_load).template createUnmanagedInstance<T>(
      getClassType(lookup_name));
  }

  bool isClassLoaded(const std::string & lookup_name) override
  {
    return find_library(getClassType(lookup_name)) != nullptr;
  }

private:
  /// The library among those that are loaded that registers a class; nothing if none does.
  class_loader::ClassLoader * find_library(const std::string & class_type) const
  {
    for (const auto & [path, library] : libraries()) {
      if (library->template isClassAvailable<T>(class_type)) {
        return library.get();
      }
    }
    return nullptr;
  }

  class_loader::ClassLoader & library_with(const std::string & lookup_name, bool may_load)
  {
    if (may_load && !isClassLoaded(lookup_name)) {
      loadLibraryForClass(lookup_name);
    }
    const auto library = find_library(getClassType(lookup_name));
    if (!library) {
      throw_not_registered(lookup_name);
    }
    return *library;
  }
};

}  // namespace pluginlib
