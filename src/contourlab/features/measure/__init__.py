"""How well did a measured run follow its path?"""
