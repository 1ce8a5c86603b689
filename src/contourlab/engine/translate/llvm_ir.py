"""The machine code of one step: its LLVM IR, and its compilation for this machine."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any

from contourlab.engine.translate.graph import Op
from contourlab.engine.translate.llvm_text import Writer
from contourlab.engine.translate.step_graph import StepGraph

SIGNATURE = ctypes.CFUNCTYPE(None, *(ctypes.c_void_p,) * 5, ctypes.c_int64, *(ctypes.c_double,) * 3, *(ctypes.c_void_p,) * 2)
_HEAD = (
    "define void @step(ptr %par, ptr %tables, ptr %ring, ptr %x, ptr %inp, i64 %mask, "
    "double %k, double %t, double %dt, ptr %next, ptr %out) {"
)


class _StepWriter(Writer):
    members = ("%x", "%next")

    def _parameter(self, op: Op, args: Sequence[str]) -> str:
        return self.load({"parameter": "%par", "state": "%x", "input": "%inp"}[op.kind], op.extra)

    _state = _input = _parameter

    def _k(self, op: Op, args: Sequence[str]) -> str:
        return f"%{op.kind}"

    _t = _dt = _ring = _k

    def _size(self, op: Op, args: Sequence[str]) -> str:
        return self.let(f"sitofp i64 {self.let('add i64 %mask, 1')} to double") if op.extra[0] == "ring" else super()._size(op, args)

    def _delayed(self, op: Op, args: Sequence[str]) -> str:
        return self.gather("%ring", self.let(f"and i64 {self.truncated(args[0])}, %mask"))


def source_of(made: StepGraph) -> str:
    """Return the LLVM IR of a step: a function ``step(par, tables, ring, x, inp, mask, k, t, dt, next, out)`` of one variant.

    `tables` has for each table its address and its size. `ring` is the past of the ring port with ``mask + 1`` values, a
    power of two. The caller stores the present value first.
    """
    writer = _StepWriter()
    writer.start("entry")
    writer.block(made.graph.top)
    for base, values in (("%next", made.states), ("%out", made.outputs)):
        for row, value in enumerate(values):
            writer.store(writer.value(value), base, str(row))
    return "\n".join([*writer.declared.values(), _HEAD, *writer.lines, "  ret void", "}"]) + "\n"


def object_code(source: str) -> bytes:
    """Compile LLVM IR to object code for this machine."""
    import llvmlite.binding as llvm

    machine = _machine()
    code: bytes = machine.emit_object(module_of(source, machine, llvm.get_process_triple()))
    return code


def module_of(source: str, machine: Any, triple: str) -> Any:
    """Return LLVM IR as a module for a target machine.

    LLVM's passes do not run: the graph has no repeated or unused operation, so they would take a third of the time and gain nothing.
    """
    import llvmlite.binding as llvm

    module = llvm.parse_assembly(source)
    module.triple, module.data_layout = triple, str(machine.target_data)
    return module


def assembly(source: str, triple: str, processor: str) -> str:
    """Return the assembly of LLVM IR for another processor."""
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(triple).create_target_machine(cpu=processor, opt=2)
    text: str = machine.emit_assembly(module_of(source, machine, triple))
    return text


def loaded(code: bytes, name: str, signature: Any) -> Any:
    """Return a function of object code as a C function."""
    import llvmlite.binding as llvm

    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
    engine.add_object_file(llvm.object_file.ObjectFileRef.from_data(code))
    engine.finalize_object()
    function = signature(engine.get_function_address(name))
    function.kept = engine  # dropping it would free the code
    return function


def _machine() -> Any:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    features = llvm.get_host_cpu_features().flatten()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(cpu=llvm.get_host_cpu_name(), features=features, opt=2, jit=True, codemodel="jitdefault")
