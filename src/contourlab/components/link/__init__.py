"""Links between the base controller and the local controller of an axis."""
