"""What functions did in a call, line by line."""
