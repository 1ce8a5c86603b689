"""What position do the signals of an encoder give?"""
