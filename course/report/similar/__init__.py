"""Shows pairs of submissions that are alike, both sides beside each other: in the terminal, as a page."""
