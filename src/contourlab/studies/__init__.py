"""Studies: the papers' reproductions, comparisons of schemes, and the verdict."""
