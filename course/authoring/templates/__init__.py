"""The texts of new files, as package data. Their words in `$...` are filled in by `fill`."""
