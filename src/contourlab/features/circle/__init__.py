"""Which causes shape a measured circle, and how large is each?"""
