"""Print a controller as a functional mock-up unit for co-simulation: FMI 2.0 and 3.0, on the C99 source of the controller.

What the interfaces have and a controller needs not (other types, saved states, derivatives) is there and answers with an error.
"""

from __future__ import annotations

import re
import uuid
from xml.sax.saxutils import quoteattr

from contourlab.engine.translate.c99 import literal
from contourlab.engine.translate.control import Control, Field, comment

VERSIONS = ("2.0", "3.0")
_TYPES_3 = ("Float32", *(f"{sign}Int{bits}" for bits in (8, 16, 32, 64) for sign in ("", "U")), "Boolean", "String", "Binary", "Clock")
_TYPES_2 = ("Integer", "Boolean", "String")
_STATES = ("GetFMU{s}tate", "SetFMU{s}tate", "FreeFMU{s}tate", "SerializedFMU{s}tateSize", "SerializeFMU{s}tate", "{de}FMU{s}tate")
_LACKS_2 = (
    *(f"{way}{kind}" for kind in _TYPES_2 for way in ("Get", "Set")),
    *(name.format(s="s", de="DeSerialize") for name in _STATES),
    *("GetDirectionalDerivative", "SetRealInputDerivatives", "GetRealOutputDerivatives", "CancelStep"),
    *(f"Get{kind}Status" for kind in ("Real", "Integer", "Boolean", "String")),
    "GetStatus",
)
_LACKS_3 = (
    *(f"{way}{kind}" for kind in _TYPES_3 for way in ("Get", "Set")),
    *(name.format(s="S", de="Deserialize") for name in _STATES),
    *("GetDirectionalDerivative", "GetAdjointDerivative", "GetOutputDerivatives"),
    *("GetNumberOfVariableDependencies", "GetVariableDependencies"),
    *("EnterConfigurationMode", "ExitConfigurationMode", "EnterEventMode", "EnterStepMode", "UpdateDiscreteStates"),
    *(f"{way}{what}{form}" for way in ("Get", "Set") for what in ("Interval", "Shift") for form in ("Decimal", "Fraction")),
    *("EvaluateDiscreteStates", "EnterContinuousTimeMode", "CompletedIntegratorStep", "SetTime", "SetContinuousStates"),
    *("GetContinuousStateDerivatives", "GetEventIndicators", "GetContinuousStates", "GetNominalsOfContinuousStates"),
    *("GetNumberOfEventIndicators", "GetNumberOfContinuousStates", "ActivateModelPartition"),
)

_COMMON = """
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "{name}.h"

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
#define LACKS(function) EXPORT int function(void *self); int function(void *self) {{ (void)self; return ERROR; }}
enum {{ OK = 0, ERROR = 3, INPUT = 1, OUTPUT = {output}, PARAMETER = {output} + 1, COUNT = {count} }};

typedef struct {{
    {name}_state state;
    double values[COUNT]; /* by value reference: time, inputs, command, parameters */
}} unit;

static void start(unit *self)
{{
    static const double values[COUNT] = {{{values}}};
    memset(self, 0, sizeof *self);
    memcpy(self->values, values, sizeof values);
}}

static void *made(const char *token)
{{
    unit *self = (strcmp(token, "{token}") == 0) ? malloc(sizeof *self) : NULL;
    if (self != NULL) {{
        start(self);
    }}
    return self;
}}

static int get(const unit *self, const uint32_t *references, size_t n, double *values)
{{
    for (size_t i = 0; i < n; ++i) {{
        if (references[i] >= COUNT) {{
            return ERROR;
        }}
        values[i] = self->values[references[i]];
    }}
    return OK;
}}

static int set(unit *self, const uint32_t *references, size_t n, const double *values)
{{
    for (size_t i = 0; i < n; ++i) {{
        if ((references[i] < INPUT) || (references[i] == OUTPUT) || (references[i] >= COUNT)) {{
            return ERROR;
        }}
        self->values[references[i]] = values[i];
    }}
    return OK;
}}

static int rest(unit *self)
{{
    {name}_init(&self->state, self->values[{feedback}]);
    return OK;
}}

/* Call the controller once for each of its periods; a step must be a whole number of them. */
static int advance(unit *self, double time, double size)
{{
    const double *const v = self->values;
    const {name}_inputs in = {{{inputs}}};
    const {name}_parameters par = {{{parameters}}};
    const double calls = floor((size / {period}) + 0.5);
    if ((calls < 1.0) || !(fabs(size - (calls * {period})) <= (1e-6 * {period}))) {{
        return ERROR;
    }}
    for (double n = 0.0; n < calls; n += 1.0) {{
        self->values[OUTPUT] = {name}_step(&self->state, &par, &in);
    }}
    self->values[0] = time + size;
    return OK;
}}
"""

_BOTH = """
const char *{fmi}GetVersion(void) {{ return "{version}"; }}
int {fmi}SetDebugLogging(void *self, {truth} on, size_t n, const char *const categories[])
{{
    (void)self; (void)on; (void)n; (void)categories;
    return OK;
}}
void {fmi}FreeInstance(void *self) {{ free(self); }}
int {fmi}ExitInitializationMode(void *self) {{ return rest(self); }}
int {fmi}Terminate(void *self) {{ (void)self; return OK; }}
int {fmi}Reset(void *self) {{ start(self); return OK; }}
"""

_FMI_2 = """const char *fmi2GetTypesPlatform(void) { return "default"; }
void *fmi2Instantiate(const char *name, int kind, const char *token, const char *place, const void *functions, int visible, int on)
{
    (void)name; (void)place; (void)functions; (void)visible; (void)on;
    return (kind == 1) ? made(token) : NULL;
}
int fmi2SetupExperiment(void *self, int tolerant, double tolerance, double first, int ends, double last)
{
    (void)tolerant; (void)tolerance; (void)ends; (void)last;
    ((unit *)self)->values[0] = first;
    return OK;
}
int fmi2EnterInitializationMode(void *self) { (void)self; return OK; }
int fmi2GetReal(void *self, const uint32_t references[], size_t n, double values[]) { return get(self, references, n, values); }
int fmi2SetReal(void *self, const uint32_t references[], size_t n, const double values[]) { return set(self, references, n, values); }
int fmi2DoStep(void *self, double time, double size, int final) { (void)final; return advance(self, time, size); }
"""

_CALLBACK = "typedef void (*callback)(void);\n"
_FMI_3 = """void *fmi3InstantiateModelExchange(void) { return NULL; }
void *fmi3InstantiateScheduledExecution(void) { return NULL; }
void *fmi3InstantiateCoSimulation(
    const char *name, const char *token, const char *place, bool visible, bool on, bool events, bool early, const uint32_t required[],
    size_t n, void *environment, callback message, callback intermediate)
{
    (void)name; (void)place; (void)visible; (void)on; (void)events; (void)early; (void)required; (void)n;
    (void)environment; (void)message; (void)intermediate;
    return made(token);
}
int fmi3EnterInitializationMode(void *self, bool tolerant, double tolerance, double first, bool ends, double last)
{
    (void)tolerant; (void)tolerance; (void)ends; (void)last;
    ((unit *)self)->values[0] = first;
    return OK;
}
int fmi3GetFloat64(void *self, const uint32_t references[], size_t n, double values[], size_t n_value)
{
    return (n == n_value) ? get(self, references, n, values) : ERROR;
}
int fmi3SetFloat64(void *self, const uint32_t references[], size_t n, const double values[], size_t n_value)
{
    return (n == n_value) ? set(self, references, n, values) : ERROR;
}
int fmi3DoStep(void *self, double time, double size, bool final, bool *event, bool *terminate, bool *early, double *last)
{
    const int done = advance(self, time, size);
    (void)final;
    *event = false; *terminate = false; *early = false; *last = ((unit *)self)->values[0];
    return done;
}
"""


def wrapper_of(made: Control, version: str) -> str:
    """Return the C source of the interface; it includes the header of `contourlab.engine.translate.control`."""
    output = 1 + len(made.inputs)
    values = [0.0, *(0.0 for _ in made.inputs), 0.0, *(p.value for p in made.parameters.values())]
    common = _COMMON.format(
        name=made.name,
        token=token_of(made),
        period=literal(made.period),
        output=output,
        count=len(values),
        values=", ".join(map(literal, values)),
        feedback=1 + [field.name for field in made.inputs.values()].index(made.feedback),
        inputs=", ".join(f"v[INPUT + {k}]" for k in range(len(made.inputs))),
        parameters=", ".join(f"v[PARAMETER + {k}]" for k in range(len(made.parameters))) or "0.0",
    )
    own, kinds, truth, lacks = (_FMI_2, "", "int", _LACKS_2) if version == "2.0" else (_FMI_3, _CALLBACK, "bool", _LACKS_3)
    prefix = f"fmi{version[0]}"
    body = _BOTH.format(fmi=prefix, version=version, truth=truth) + own
    heads = "".join(f"EXPORT {head};\n" for head in re.findall(r"^(\w[^;{}]*?\))\s*\{", body, re.MULTILINE))
    return "\n".join([comment(made.notes), common, f"\n{kinds}{heads}{body}", *(f"LACKS({prefix}{name})" for name in lacks), ""])


def token_of(made: Control) -> str:
    """Return the identity that ties description and binary together."""
    return f"{{{uuid.uuid5(uuid.NAMESPACE_OID, made.name + ''.join(made.notes))}}}"


def description_of(made: Control, version: str) -> str:
    """Return ``modelDescription.xml``."""
    three = version == "3.0"
    groups = (
        (made.inputs.values(), 'causality="input" variability="continuous"'),
        ([made.output], 'causality="output" variability="discrete" initial="exact"'),
        (made.parameters.values(), 'causality="parameter" variability="tunable" initial="exact"'),
    )
    fields = [(field, kind) for group, kind in groups for field in group]
    units = dict.fromkeys(field.unit for field, _ in fields if field.unit)
    time = ['<Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>'] if three else []
    variables = [_variable(number, field, kind, three) for number, (field, kind) in enumerate(fields, start=1)]
    output = 1 + len(made.inputs)
    sources = "".join(f"<File name={quoteattr(file)}/>" for file in source_files(made))
    attributes = f'modelIdentifier="{made.name}" canHandleVariableCommunicationStepSize="false"'
    kind = f'<CoSimulation {attributes} fixedInternalStepSize="{made.period!r}"/>'
    old = f"<CoSimulation {attributes}><SourceFiles>{sources}</SourceFiles></CoSimulation>"
    known = f'<Output valueReference="{output}"/>' if three else f'<Outputs><Unknown index="{output}"/></Outputs>'
    head = f'{"instantiationToken" if three else "guid"}="{token_of(made)}" generationTool="contourlab"'
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<fmiModelDescription fmiVersion="{version}" modelName="{made.name}" {head} description={quoteattr(" ".join(made.notes))}>',
            f"  {kind if three else old}",
            f"  <UnitDefinitions>{''.join(f'<Unit name={quoteattr(unit)}/>' for unit in units)}</UnitDefinitions>",
            f'  <DefaultExperiment startTime="0.0" stepSize="{made.period!r}"/>',
            "  <ModelVariables>",
            *(f"    {line}" for line in (*time, *variables)),
            "  </ModelVariables>",
            f"  <ModelStructure>{known}</ModelStructure>",
            "</fmiModelDescription>",
            "",
        ]
    )


def build_description_of(made: Control) -> str:
    """Return ``sources/buildDescription.xml`` of FMI 3.0."""
    files = "".join(f"<SourceFile name={quoteattr(file)}/>" for file in source_files(made))
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiBuildDescription fmiVersion="3.0">\n'
        f'  <BuildConfiguration modelIdentifier="{made.name}">\n'
        f'    <SourceFileSet language="C99">{files}</SourceFileSet>\n  </BuildConfiguration>\n</fmiBuildDescription>\n'
    )


def source_files(made: Control) -> tuple[str, str]:
    """Return the names of the source files to compile."""
    return f"{made.name}.c", f"{made.name}_fmi.c"


def _variable(number: int, field: Field, kind: str, three: bool) -> str:
    unit = f" unit={quoteattr(field.unit)}" if field.unit else ""
    start = f'start="{field.value!r}"'.replace("inf", "INF")
    head = f'name="{field.name}" valueReference="{number}" {kind} description={quoteattr(field.doc)}'
    return f"<Float64 {head} {start}{unit}/>" if three else f"<ScalarVariable {head}><Real {start}{unit}/></ScalarVariable>"
