#pragma once

#include <dlfcn.h>

#include <algorithm>
#include <atomic>
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
  : path_(library_path), is_on_demand_(ondemand_load_unload)
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
  bool isLibraryLoaded() const {return path_.empty() || loads_ > 0;}
  void loadLibrary()
  {
    if (path_.empty()) {
      return;
    }
    const std::string before = detail::library_being_loaded();
    detail::library_being_loaded() = path_;
    const bool is_loaded = dlopen(path_.c_str(), RTLD_NOW | RTLD_NODELETE) != nullptr;
    detail::library_being_loaded() = before;
    if (!is_loaded) {
      throw LibraryLoadException("Could not load library " + path_ + ": " + dlerror());
    }
    ++loads_;
  }
  /// Takes back one `loadLibrary`, unless there are objects that this made and manages. Returns how many are
  /// left.
  int unloadLibrary()
  {
    if (loads_ > 0 && *objects_ == 0) {
      --loads_;
    }
    return loads_;
  }

  /// Names as they were registered. Those of libraries that the program is linked with are always among them.
  template<typename BaseT>
  std::vector<std::string> getAvailableClasses() const
  {
    auto & registry = detail::registry_of<BaseT>();
    const std::lock_guard lock(registry.mutex);
    std::vector<std::string> names;
    for (const auto & [name, entry] : registry.entries) {
      if (offers(entry)) {
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
    UniquePtr<BaseT> object(
      createUnmanagedInstance<BaseT>(derived_class_name), [objects = objects_](BaseT * made) {
        delete made;
        --*objects;
      });
    ++*objects_;
    return object;
  }
  /// To be deleted by the caller.
  template<typename BaseT>
  BaseT * createUnmanagedInstance(const std::string & derived_class_name)
  {
    if (!isLibraryLoaded()) {
      loadLibrary();
    }
    auto & registry = detail::registry_of<BaseT>();
    std::unique_lock lock(registry.mutex);
    const auto found = registry.entries.find(derived_class_name);
    if (found == registry.entries.end() || !offers(found->second)) {
      throw CreateClassException("Could not create instance of type " + derived_class_name);
    }
    const auto make = found->second.make;
    lock.unlock();
    return static_cast<BaseT *>(make());
  }

private:
  bool offers(const detail::Registry::Entry & entry) const
  {
    return entry.library.empty() || entry.library == path_;
  }

  const std::string path_;
  const bool is_on_demand_;
  int loads_ = 0;
  /// How many there are of those that this made and manages; they may outlive it.
  const std::shared_ptr<std::atomic<int>> objects_ = std::make_shared<std::atomic<int>>(0);
};

}  // namespace class_loader
