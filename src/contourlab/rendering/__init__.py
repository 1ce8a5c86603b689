"""Rendering of results: tables, plots and the one-file HTML report.

`data` holds the contents of a report; `run_pictures`, `path_picture`, `learning_pictures` and `switching` turn it into `charts`;
`plotly_view` and `html` make the page, `matplotlib_view` and `plots` single files, `one_page` short pages; `comparison`, `page_tables` and
`table` make the tables. plotly, matplotlib, jinja2 and rich are imported when used.
"""
