"""What to load and to run to record a part program on the machine?"""
