"""What is wrong with discovery, judged by what a capture shows of it."""
