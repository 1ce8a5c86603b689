"""What is the error at the worst place made of, and which changes help most?"""
