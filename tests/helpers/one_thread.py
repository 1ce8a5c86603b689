"""One thread for linear algebra, as in the command: processes that share processors would wait for each other's threads.

NumPy's libraries read the number once, when loaded: import this first.
"""

import os

from contourlab.__main__ import LINEAR_ALGEBRA

for library in LINEAR_ALGEBRA:
    os.environ.setdefault(library, "1")
