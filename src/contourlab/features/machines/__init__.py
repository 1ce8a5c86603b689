"""Which machines are shipped, and how is a new one described?"""
