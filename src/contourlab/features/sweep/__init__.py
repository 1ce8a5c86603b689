"""Studies of thousands to millions of variants: a study file, a store, and questions to the store."""
