"""Processes that a launch starts: how they are made, heard and ended."""
