"""Which position do the signals of an encoder give?"""
