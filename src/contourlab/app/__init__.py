"""What features share as an application: staging of results, checkpoints, progress, inputs."""
