"""Native: machine code for the rooms above.

`store` keeps machine code on disk under a key made of its sources; `door` compiles a plain function through it. Numba is imported where
one of the two is imported, never by this package itself: a room that wants a kernel asks for it when it needs it.
"""
