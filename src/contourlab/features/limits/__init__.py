"""Does a commanded motion keep the limits of a machine, and where is it worst?"""
