"""Which parameters bring the simulated run onto the measured one?"""
