"""Makes courses, chapters and exercises to start from: small, complete, and right as they are."""
