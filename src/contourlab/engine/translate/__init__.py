"""Translate the step of a component: its Python source becomes a graph of operations, and the graph C99 or machine code.

`graph` holds the operations. `source` finds the syntax tree of a function and names its lines. `evaluate` runs the tree over graph values.
`maths` has the primitives as operations. `step_graph` makes the graph of one step, and of a tick of many. `c99` and `llvm_ir` print it.
`control` is a whole controller, with its C99; `hal`, `structured_text` and `fmi` print it too.
"""
