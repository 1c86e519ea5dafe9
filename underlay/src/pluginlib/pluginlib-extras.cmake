ament_register_extension(ament_package pluginlib pluginlib_package_hook.cmake)

# Installs a file that describes plugins, and notes it for the index:
# pluginlib_export_plugin_description_file(<package of the base class> <file, relative to this folder>).
function(pluginlib_export_plugin_description_file category file)
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    message(FATAL_ERROR "pluginlib_export_plugin_description_file() needs a file that exists. Missing:\n"
      "  ${CMAKE_CURRENT_SOURCE_DIR}/${file}")
  endif()
  get_filename_component(folder "${file}" DIRECTORY)
  install(FILES "${file}" DESTINATION "share/${PROJECT_NAME}/${folder}")
  get_property(categories GLOBAL PROPERTY pluginlib_categories)
  if(NOT category IN_LIST categories)
    set_property(GLOBAL APPEND PROPERTY pluginlib_categories "${category}")
  endif()
  set_property(GLOBAL APPEND_STRING PROPERTY "pluginlib_files_of_${category}"
    "share/${PROJECT_NAME}/${file}\n")
endfunction()
