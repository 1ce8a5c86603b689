"""Rendering of results: tables, plots and the one-file HTML report.

`data` holds the contents of a report; `run_pictures`, `path_picture`, `learning_pictures` and `switching` turn it into `charts`.
`html` makes the page, with a `message` to the viewer, whose sources are in ``page/``; `matplotlib_view` and `plots` make single files,
`one_page` short pages; `comparison`, `page_tables` and `table` make the tables. matplotlib, jinja2 and rich are imported when used.
"""
