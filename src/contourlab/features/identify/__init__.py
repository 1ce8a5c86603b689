"""Which model of an axis follows from its logs?"""
