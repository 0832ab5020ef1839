"""What tests of claims compute, by topic: swarms, frames, and what was found beside the model."""
