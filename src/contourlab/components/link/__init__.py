"""Links between the base controller and the local controller of an axis: what a message does to a signal."""
