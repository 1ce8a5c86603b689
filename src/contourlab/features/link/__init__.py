"""What does a network between base and local controllers cost?"""
