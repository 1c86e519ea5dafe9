"""`pytest graders/` runs every grader on the reference solutions."""

pytest_plugins = ["course.grading.on_solutions"]
