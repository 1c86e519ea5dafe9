"""What can be found wrong with a course without grading anything: its files, texts, links and commands."""
