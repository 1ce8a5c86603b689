"""How large is the backlash of each axis, and which compensation is best?"""
