"""Is a part program sound, and what does it move?"""
