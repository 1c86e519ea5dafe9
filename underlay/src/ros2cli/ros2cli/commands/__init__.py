"""Commands: one module each; those that only hold verbs need none. See README.md."""
