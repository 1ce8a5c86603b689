"""What is the error at the worst place made of, and which single change helps most?"""
