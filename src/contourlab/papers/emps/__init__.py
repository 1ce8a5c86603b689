"""EMPS: Janot, Gautier & Brunot, identification of an electro-mechanical positioning system."""
