# Writes an entry to the index for each package whose base classes have plugins in this one.
get_property(_pluginlib_categories GLOBAL PROPERTY pluginlib_categories)
foreach(_pluginlib_category IN LISTS _pluginlib_categories)
  get_property(_pluginlib_files GLOBAL PROPERTY "pluginlib_files_of_${_pluginlib_category}")
  ament_index_register_resource("${_pluginlib_category}__pluginlib__plugin" CONTENT "${_pluginlib_files}")
endforeach()
