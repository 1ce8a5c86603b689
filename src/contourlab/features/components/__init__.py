"""What can a machine and its controller be made of?"""
