"""Pictures of evidence in the terminal: the time line, signals, and who publishes to whom."""
