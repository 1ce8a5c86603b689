"""Learning laws: from the record of a trial to the table that the next trial adds."""
