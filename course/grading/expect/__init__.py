"""Expectations that many graders share. Each returns in silence or raises a `Failure`."""
