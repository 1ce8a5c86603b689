"""A GPU that is none: the functions for a GPU, compiled for the processor and run thread by thread."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.gpu import THREADS
from contourlab.engine.translate.tick_loop import SIGNATURE
from contourlab.native import llvm


class HostMemory:
    """Memory of this machine, which like that of a GPU holds anything at first."""

    def __init__(self, n: int) -> None:
        self.values = np.full(n, np.nan)
        self.address = self.values.ctypes.data

    def write(self, values: Array) -> None:
        self.values[: values.size] = values.view(float).ravel()

    def read(self, values: Array) -> None:
        values.reshape(-1)[:] = self.values[: values.size]


class HostGpu:
    """Stands in for `contourlab.engine.gpu.Gpu`."""

    code = "for the processor, one thread after another"

    def use(self) -> None:
        pass

    def memory(self, n: int) -> HostMemory:
        return HostMemory(n)

    def compiled(self, source: str) -> bytes:
        """Compile IR whose number of the thread comes from an argument instead of a register of the GPU."""
        text = re.sub(r"declare i32 @llvm.nvvm.*\n", "", source)
        text = re.sub(r"call i32 @llvm.nvvm.read.ptx.sreg.(\w+).x\(\)", lambda found: f"add i32 0, {_PLACE[found[1]]}", text)
        text = text.replace("ptx_kernel void", "void").replace("double %period)", "double %period, i64 %number)")
        text = text.replace("entry:", "entry:\n  %own = trunc i64 %number to i32", 1)
        return llvm.object_code(text)

    def loaded(self, code: bytes) -> Any:
        return llvm.loaded(code, "run", SIGNATURE)

    def run(self, function: Any, width: int, arguments: Sequence[Any]) -> None:
        assert width % THREADS == 0
        for number in range(width):
            function(*(argument.value for argument in arguments), ctypes.c_int64(number))


_PLACE = {"tid": "%own", "ctaid": "0", "ntid": "1"}
