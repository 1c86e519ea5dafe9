"""The texts of new files, as package data. `filled` replaces the words in them that begin with `$`."""
