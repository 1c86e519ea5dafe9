#pragma once

#include <dlfcn.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "class_loader/exceptions.hpp"
#include "class_loader/register_macro.hpp"
#include "class_loader/registry.hpp"

namespace class_loader
{

/// Makes objects of the classes that a library has registered. A library stays loaded once it is: there may be
/// objects of its classes anywhere.
class ClassLoader
{
public:
  template<typename BaseT>
  using DeleterType = std::function<void(BaseT *)>;
  template<typename BaseT>
  using UniquePtr = std::unique_ptr<BaseT, DeleterType<BaseT>>;

  /// An empty path stands for the libraries that the program is linked with. Throws LibraryLoadException.
  explicit ClassLoader(const std::string & library_path, bool ondemand_load_unload = false)
  : path_(library_path), is_on_demand_(ondemand_load_unload), is_loaded_(library_path.empty())
  {
    if (!is_on_demand_) {
      loadLibrary();
    }
  }
  ClassLoader(const ClassLoader &) = delete;
  ClassLoader & operator=(const ClassLoader &) = delete;
  virtual ~ClassLoader() = default;

  const std::string & getLibraryPath() const {return path_;}
  bool isOnDemandLoadUnloadEnabled() const {return is_on_demand_;}
  bool isLibraryLoaded() const {return is_loaded_;}
  void loadLibrary()
  {
    if (isLibraryLoaded()) {
      return;
    }
    const std::string before = detail::library_being_loaded();
    detail::library_being_loaded() = path_;
    is_loaded_ = dlopen(path_.c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE) != nullptr;
    detail::library_being_loaded() = before;
    if (!is_loaded_) {
      throw LibraryLoadException("Could not load library " + path_ + ": " + dlerror());
    }
  }
  /// How many more times this must be called for the library to be unloaded: 0.
  int unloadLibrary()
  {
    is_loaded_ = path_.empty();
    return 0;
  }

  /// Names as they were registered.
  template<typename BaseT>
  std::vector<std::string> getAvailableClasses() const
  {
    auto & registry = detail::Registry<BaseT>::get();
    const std::lock_guard lock(registry.mutex);
    std::vector<std::string> names;
    for (const auto & [name, entry] : registry.entries) {
      if (entry.library == path_) {
        names.push_back(name);
      }
    }
    return names;
  }
  template<typename BaseT>
  bool isClassAvailable(const std::string & class_name) const
  {
    const auto names = getAvailableClasses<BaseT>();
    return std::find(names.begin(), names.end(), class_name) != names.end();
  }

  // All of these throw CreateClassException if there is no such class.
  template<typename BaseT>
  std::shared_ptr<BaseT> createInstance(const std::string & derived_class_name)
  {
    return createUniqueInstance<BaseT>(derived_class_name);
  }
  template<typename BaseT>
  std::shared_ptr<BaseT> createSharedInstance(const std::string & derived_class_name)
  {
    return createUniqueInstance<BaseT>(derived_class_name);
  }
  template<typename BaseT>
  UniquePtr<BaseT> createUniqueInstance(const std::string & derived_class_name)
  {
    return UniquePtr<BaseT>(
      createUnmanagedInstance<BaseT>(derived_class_name), std::default_delete<BaseT>());
  }
  /// To be deleted by the caller.
  template<typename BaseT>
  BaseT * createUnmanagedInstance(const std::string & derived_class_name)
  {
    loadLibrary();
    auto & registry = detail::Registry<BaseT>::get();
    std::unique_lock lock(registry.mutex);
    const auto found = registry.entries.find(derived_class_name);
    if (found == registry.entries.end() || found->second.library != path_) {
      throw CreateClassException("Could not create instance of type " + derived_class_name);
    }
    const auto make = found->second.make;
    lock.unlock();
    return make();
  }

private:
  const std::string path_;
  const bool is_on_demand_;
  bool is_loaded_;
};

}  // namespace class_loader
