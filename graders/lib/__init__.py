"""Code that graders of several chapters share, or that would make one of them too long."""
