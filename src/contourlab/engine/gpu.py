"""An NVIDIA GPU through its driver alone: memory, and a function of LLVM IR run by one thread for each variant.

The driver compiles the portable assembly (PTX) that LLVM prints, so neither a CUDA toolkit nor a Python package is needed.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Sequence
from functools import cache
from typing import Any

from contourlab.arrays import Array, Index
from contourlab.engine.translate import llvm_ir
from contourlab.errors import EngineError, refuse

THREADS = 64
"""Threads of a block."""
LANES, BYTES = 1 << 16, 1 << 30
"""Most lanes of a group, which fill the largest GPUs, and most memory of one."""
_ADDRESS, _COUNT, _NAME = ctypes.c_uint64, ctypes.c_size_t, ctypes.c_char_p
_SIGNATURES: dict[str, tuple[Any, ...]] = {
    "cuInit": (ctypes.c_uint,),
    "cuDeviceGet": (ctypes.c_void_p, ctypes.c_int),
    "cuDevicePrimaryCtxRetain": (ctypes.c_void_p, ctypes.c_int),
    "cuCtxSetCurrent": (ctypes.c_void_p,),
    "cuCtxSynchronize": (),
    "cuModuleLoadData": (ctypes.c_void_p, _NAME),
    "cuModuleGetFunction": (ctypes.c_void_p, ctypes.c_void_p, _NAME),
    "cuMemAlloc_v2": (ctypes.c_void_p, _COUNT),
    "cuMemFree_v2": (_ADDRESS,),
    "cuMemcpyHtoD_v2": (_ADDRESS, ctypes.c_void_p, _COUNT),
    "cuMemcpyDtoH_v2": (ctypes.c_void_p, _ADDRESS, _COUNT),
    "cuLaunchKernel": (ctypes.c_void_p, *(ctypes.c_uint,) * 7, *(ctypes.c_void_p,) * 3),
    "cuGetErrorString": (ctypes.c_int, ctypes.c_void_p),
}
_OUT_OF_MEMORY = 2
_OLDEST = ("nvptx64-nvidia-cuda", "sm_60")
"""Pascal, of 2016; drivers compile for newer ones."""


class Memory:
    """Numbers in the memory of a GPU; freed with the object.

    Attributes
    ----------
    address : int
    """

    def __init__(self, gpu: Gpu, n: int) -> None:
        self._gpu, place = gpu, _ADDRESS()
        gpu.call("cuMemAlloc_v2", ctypes.byref(place), 8 * max(n, 1))
        self.address = place.value or 0

    def write(self, values: Array | Index) -> None:
        """Copy numbers to the GPU, to the beginning of this memory."""
        self._gpu.call("cuMemcpyHtoD_v2", self.address, values.ctypes.data, values.nbytes)

    def read(self, values: Array) -> None:
        """Copy numbers from the beginning of this memory into an array."""
        self._gpu.call("cuMemcpyDtoH_v2", values.ctypes.data, self.address, values.nbytes)

    def __del__(self) -> None:
        if hasattr(self, "address"):
            self._gpu.free(self.address)


class Gpu:
    """The first GPU that the driver shows; ``CUDA_VISIBLE_DEVICES`` chooses another.

    Raises
    ------
    EngineError
        If there is no driver or no GPU.
    """

    code = " ".join(_OLDEST)
    """What `compiled` returns."""

    def __init__(self) -> None:
        try:
            self._driver = ctypes.CDLL("nvcuda.dll" if sys.platform == "win32" else "libcuda.so.1")
        except OSError as error:
            raise EngineError("no NVIDIA driver on this machine, so no GPU") from error
        for name, takes in _SIGNATURES.items():
            getattr(self._driver, name).argtypes = takes
        self._context = ctypes.c_void_p()
        device = ctypes.c_int()
        self.call("cuInit", 0)
        self.call("cuDeviceGet", ctypes.byref(device), 0)
        self.call("cuDevicePrimaryCtxRetain", ctypes.byref(self._context), device)
        self.use()

    def call(self, name: str, *arguments: Any) -> None:
        """Call a function of the driver.

        Raises
        ------
        EngineError
            If it fails.
        """
        code = getattr(self._driver, name)(*arguments)
        refuse(code == _OUT_OF_MEMORY, EngineError, "the GPU has no memory left: does another program use it?")
        if code:
            text = _NAME()
            self._driver.cuGetErrorString(code, ctypes.byref(text))
            raise EngineError(f"GPU: {name}: {(text.value or b'unknown error').decode()}")

    def use(self) -> None:
        """Let the calling thread use this GPU."""
        self.call("cuCtxSetCurrent", self._context)

    def free(self, address: int) -> None:
        """Free memory; errors are nobody's to mend."""
        self._driver.cuCtxSetCurrent(self._context)
        self._driver.cuMemFree_v2(address)

    def memory(self, n: int) -> Memory:
        """Return memory for n numbers, not set."""
        return Memory(self, n)

    def compiled(self, source: str) -> bytes:
        """Return some LLVM IR as portable assembly."""
        return str(llvm_ir.assembly(source, *_OLDEST)).encode()

    def loaded(self, assembly: bytes) -> Any:
        """Return the function ``run`` of portable assembly."""
        module, function = ctypes.c_void_p(), ctypes.c_void_p()
        self.call("cuModuleLoadData", ctypes.byref(module), assembly)
        self.call("cuModuleGetFunction", ctypes.byref(function), module, b"run")
        return function

    def run(self, function: Any, width: int, arguments: Sequence[Any]) -> None:
        """Run a function in `width` threads, a multiple of `THREADS`, and wait for the last."""
        pointers = (ctypes.c_void_p * len(arguments))(*(ctypes.addressof(value) for value in arguments))
        self.call("cuLaunchKernel", function, width // THREADS, 1, 1, THREADS, 1, 1, 0, None, pointers, None)
        self.call("cuCtxSynchronize")


def lanes_of(n: int, n_row: int) -> int:
    """Return the lanes of each group for n variants with this many rows of memory: a power of two."""
    return max(min(1 << (n - 1).bit_length(), LANES, 1 << (BYTES // (8 * n_row)).bit_length() - 1), THREADS)


@cache
def gpu_of_process() -> Gpu:
    """Return the GPU of this process."""
    return Gpu()
