"""Learning from trial to trial: convergence, and the design of its filters."""
