"""The cost of a network between base and local controllers."""
