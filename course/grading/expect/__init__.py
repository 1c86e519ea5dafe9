"""Expectations that many graders share. Each raises a `Failure` unless it is met."""
