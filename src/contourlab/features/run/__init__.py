"""How far does the tool stray from the path, why, and what helps?"""
