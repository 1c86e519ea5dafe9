"""Makes courses, chapters and exercises to start from: small, complete, and correct as they are."""
