"""Which components can a machine and its controller have?"""
