"""Which gains should the control have, and what does that take?"""
