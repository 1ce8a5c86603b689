"""How far are the loops from instability, and does learning converge?"""
