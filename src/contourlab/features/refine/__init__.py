"""Which parameters make the simulated run follow the measured one?"""
