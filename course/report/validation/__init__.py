"""Shows what was proven of a course: a table in the terminal, JUnit XML, annotations on its lines."""
