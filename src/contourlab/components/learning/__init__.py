"""What one trial teaches the next: laws that turn the record of a trial into the table that the next one adds."""
