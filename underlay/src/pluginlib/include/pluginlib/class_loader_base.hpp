#pragma once

#include <string>
#include <vector>

namespace pluginlib
{

/// Everything about a class loader that has nothing to do with the type of its base class.
class ClassLoaderBase
{
public:
  virtual ~ClassLoaderBase() = default;

  /// The files that describe plugins.
  virtual std::vector<std::string> getPluginXmlPaths() = 0;
  /// The names of all classes that can be made, in alphabetical order.
  virtual std::vector<std::string> getDeclaredClasses() = 0;
  /// Reads the index and the files again. Classes whose library is loaded stay as they are.
  virtual void refreshDeclaredClasses() = 0;
  virtual std::string getBaseClassType() const = 0;
  /// The last part of a name: `Square` in `shapes::Square` and in `shapes/Square`.
  virtual std::string getName(const std::string & lookup_name) = 0;
  virtual bool isClassAvailable(const std::string & lookup_name) = 0;

  // Texts about a class. They are empty if there is no such class.
  virtual std::string getClassType(const std::string & lookup_name) = 0;
  virtual std::string getClassDescription(const std::string & lookup_name) = 0;
  virtual std::string getClassPackage(const std::string & lookup_name) = 0;
  virtual std::string getPluginManifestPath(const std::string & lookup_name) = 0;

  /// Where the library of a class is. Throws LibraryLoadException if there is no such class or file.
  virtual std::string getClassLibraryPath(const std::string & lookup_name) = 0;
  virtual bool isClassLoaded(const std::string & lookup_name) = 0;
  /// Throws LibraryLoadException.
  virtual void loadLibraryForClass(const std::string & lookup_name) = 0;
  /// Returns 0, or 1 while there are objects that this loader made and manages: the library stays until they
  /// are gone and this is called again. Throws LibraryUnloadException if the library was never loaded.
  virtual int unloadLibraryForClass(const std::string & lookup_name) = 0;
  /// The paths of the libraries that are loaded.
  virtual std::vector<std::string> getRegisteredLibraries() = 0;
};

}  // namespace pluginlib
