"""LLVM: modules in its language to machine code of this processor, and that to functions of C."""

from __future__ import annotations

from functools import cache
from typing import Any

import llvmlite.binding as llvm


def module_of(source: str | bytes, machine: Any, triple: str) -> Any:
    """Return text or bitcode of LLVM as a module for a target machine."""
    module = llvm.parse_bitcode(source) if isinstance(source, bytes) else llvm.parse_assembly(source)
    module.triple, module.data_layout = triple, str(machine.target_data)
    return module


def object_code(source: str | bytes, *, optimised: bool = False) -> bytes:
    """Return the object code for this machine of text or bitcode of LLVM; with `optimised`, after all passes of LLVM."""
    machine = _machine()
    module = module_of(source, machine, llvm.get_process_triple())
    if optimised:
        options = llvm.create_pipeline_tuning_options(speed_level=3)
        options.loop_vectorization = True
        builder = llvm.create_pass_builder(machine, options)
        builder.getModulePassManager().run(module, builder)
    code: bytes = machine.emit_object(module)
    return code


def loaded(code: bytes, name: str, signature: Any) -> Any:
    """Return a function of object code as a C function."""
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
    engine.add_object_file(llvm.object_file.ObjectFileRef.from_data(code))
    engine.finalize_object()
    function = signature(engine.get_function_address(name))
    function.kept = engine  # dropping it would free the code
    return function


@cache
def _host() -> tuple[Any, str, str]:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple(), llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def _machine() -> Any:
    target, name, features = _host()
    return target.create_target_machine(cpu=name, features=features, opt=2, jit=True, codemodel="jitdefault")
