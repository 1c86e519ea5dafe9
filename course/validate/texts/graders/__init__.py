"""What is wrong with grader modules: by loading them, and by reading what they declare."""
