"""How well does a measured run follow its path?"""
