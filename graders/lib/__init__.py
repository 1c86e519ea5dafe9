"""Code that graders of several chapters share, or that would make a single one too long."""
