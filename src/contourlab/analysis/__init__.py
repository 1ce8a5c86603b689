"""Models and theory of the loop; no time simulation: linear loops, learning, backlash, identification, encoders."""
