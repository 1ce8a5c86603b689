# ruff: noqa
# fmt: off
"""Types of the public names, made by ``python tools/surface.py``: do not edit."""

from collections.abc import Callable as Callable
from collections.abc import Sequence
from contourlab.analysis.learning.learning_analysis import learning_analysis as learning_analysis
from contourlab.analysis.linear.contour_transfer import contour_margins as contour_margins
from contourlab.analysis.linear.contour_transfer import internal_stability as internal_stability
from contourlab.analysis.linear.systems import from_system as from_system
from contourlab.analysis.linear.systems import linear as linear
from contourlab.app.cite import cite as cite
from contourlab.components.conformance import check_component as check_component
from contourlab.components.contract import Component as Component
from contourlab.components.contract import param as param
from contourlab.components.contract import text_param as text_param
from contourlab.components.learning.law import LearningLaw as LearningLaw
from contourlab.components.plant.plant import Plant as Plant
from contourlab.components.plant.plant import reflected_inertia as reflected_inertia
from contourlab.components.plant.plant import reflected_mass as reflected_mass
from contourlab.components.registry import component as component
from contourlab.components.registry import load_plugin as load_plugin
from contourlab.contours.reader import read_contour as read_contour
from contourlab.engine.step import Port as Port
from contourlab.errors import ContourlabError as ContourlabError
from contourlab.errors import DivergenceError as DivergenceError
from contourlab.features.analyse.command import Analysis as Analysis
from contourlab.features.backlash.command import BacklashOutcome as BacklashOutcome
from contourlab.features.check.program_check import Checked as Checked
from contourlab.features.circle.command import CircleTest as CircleTest
from contourlab.features.commission.command import Commissioned as Commissioned
from contourlab.features.commission.log_command import LogCommissioned as LogCommissioned
from contourlab.features.commission.relay_command import RelayCommissioned as RelayCommissioned
from contourlab.features.export.command import Exported as Exported
from contourlab.features.identify.result import Identification as Identification
from contourlab.features.interpolate.command import Interpolated as Interpolated
from contourlab.features.learn.run import LearningRun as LearningRun
from contourlab.features.learn.run import Part as Part
from contourlab.features.learn.run import Stopping as Stopping
from contourlab.features.learn.table import LearnedTable as LearnedTable
from contourlab.features.learn.trial import TrialFigures as TrialFigures
from contourlab.features.limits.command import LimitTest as LimitTest
from contourlab.features.link.cost import message_rate as message_rate
from contourlab.features.link.result import LinkResult as LinkResult
from contourlab.features.measure.command import MeasuredRuns as MeasuredRuns
from contourlab.features.notch.command import Notched as Notched
from contourlab.features.precompensate.command import Precompensated as Precompensated
from contourlab.features.record.command import Recording as Recording
from contourlab.features.refine.command import Refinement as Refinement
from contourlab.features.run.command import Planned as Planned
from contourlab.features.run.command import Runs as Runs
from contourlab.features.run.record import simulate_to_file as simulate_to_file
from contourlab.features.run.report import report as report
from contourlab.features.run.show import show as show
from contourlab.features.run.source import Source as Source
from contourlab.features.run.verdict import verdict as verdict
from contourlab.features.sensitivity.command import Sensitivity as Sensitivity
from contourlab.features.swap.report import SwapResult as SwapResult
from contourlab.features.sweep.command import Rows as Rows
from contourlab.features.sweep.command import Search as Search
from contourlab.features.sweep.command import SweepSummary as SweepSummary
from contourlab.features.sweep.query import Export as ExportedRows
from contourlab.features.sweep.report import SweepReport as SweepReport
from contourlab.features.tune.command import Calibration as Calibration
from contourlab.feed.blending import blended as blended
from contourlab.feed.bounds import AxisLimits as AxisLimits
from contourlab.feed.planner import plan as plan
from contourlab.feed.reference import Reference as Reference
from contourlab.feed.reference import uniform as uniform
from contourlab.feed.route import Route as Route
from contourlab.feed.route import route_from_path as route_from_path
from contourlab.feed.route import route_from_program as route_from_program
from contourlab.feed.verify import limit_report as limit_report
from contourlab.geometry.library import contour as contour
from contourlab.geometry.library import contour_names as contour_names
from contourlab.geometry.line_and_arc import Arc as Arc
from contourlab.geometry.line_and_arc import Line as Line
from contourlab.geometry.nurbs import Nurbs as Nurbs
from contourlab.geometry.path import Path as Path
from contourlab.geometry.view import PathView as PathView
from contourlab.logs.load import Log as Log
from contourlab.logs.load import load_log as load_log
from contourlab.loop.batch import BatchResult as BatchResult
from contourlab.loop.batch import simulate_batch as simulate_batch
from contourlab.loop.feeding import Learned as Learned
from contourlab.loop.machine import Axis as Axis
from contourlab.loop.machine import AxisController as AxisController
from contourlab.loop.machine import AxisError as AxisError
from contourlab.loop.machine import Controller as Controller
from contourlab.loop.machine import Division as Division
from contourlab.loop.machine import Limits as Limits
from contourlab.loop.machine import Machine as Machine
from contourlab.loop.parameters import parameter_names as parameter_names
from contourlab.loop.parameters import with_values as with_values
from contourlab.loop.simulate import simulate as simulate
from contourlab.loop.stepping import Loop as Loop
from contourlab.loop.switches import Change as Change
from contourlab.metrics.circles import backlash_from_circle as backlash_from_circle
from contourlab.metrics.circles import backlash_of_runs as backlash_of_runs
from contourlab.metrics.circles import circles_of as circles_of
from contourlab.metrics.figures import Metrics as Metrics
from contourlab.metrics.figures import summarise as summarise
from contourlab.metrics.judge import judge as judge
from contourlab.metrics.lost_motion import lost_motion_from_pair as lost_motion_from_pair
from contourlab.metrics.reversals import reversal_spikes as reversal_spikes
from contourlab.papers.run import Reproduction as Reproduction
from contourlab.program.moves import Program as Program
from contourlab.program.reader import Reading as Reading
from contourlab.program.reader import parse_program as parse_program
from contourlab.program.reader import read_program as read_program
from contourlab.result.result import Result as Result
from contourlab.result.signals import Signal as Signal
from contourlab.result.signals import Status as Status
from contourlab.scenario.dump import save as save
from contourlab.scenario.load import load_scenario as load_scenario
from contourlab.scenario.translation import translate as translate
from contourlab.scenario.values import Scenario as Scenario
from pathlib import Path as File
from typing import Any as Any
from typing import overload

__version__: str

__all__ = [
    "__version__",
    "Arc",
    "Axis",
    "AxisController",
    "AxisError",
    "AxisLimits",
    "BatchResult",
    "Change",
    "Component",
    "ContourlabError",
    "Controller",
    "DivergenceError",
    "Division",
    "Learned",
    "LearnedTable",
    "Limits",
    "Line",
    "Loop",
    "Machine",
    "Metrics",
    "Nurbs",
    "Path",
    "Plant",
    "Port",
    "Program",
    "Reading",
    "Reference",
    "Result",
    "Route",
    "Scenario",
    "Signal",
    "Status",
    "Stopping",
    "analyse",
    "backlash",
    "backlash_from_circle",
    "backlash_of_runs",
    "blended",
    "check",
    "check_component",
    "circle",
    "circles_of",
    "cite",
    "commission",
    "compare",
    "component",
    "contour",
    "contour_margins",
    "contour_names",
    "export",
    "from_system",
    "identify",
    "internal_stability",
    "interpolate",
    "judge",
    "learn",
    "learning_analysis",
    "limit_report",
    "limits",
    "linear",
    "link",
    "load_log",
    "load_plugin",
    "load_scenario",
    "lost_motion_from_pair",
    "measure",
    "message_rate",
    "notch",
    "param",
    "parameter_names",
    "parse_program",
    "plan",
    "precompensate",
    "read_contour",
    "read_program",
    "record",
    "refine",
    "reflected_inertia",
    "reflected_mass",
    "report",
    "reproduce",
    "reversal_spikes",
    "route_from_path",
    "route_from_program",
    "run",
    "save",
    "sensitivity",
    "show",
    "simulate",
    "simulate_batch",
    "simulate_to_file",
    "summarise",
    "swap",
    "sweep",
    "text_param",
    "translate",
    "tune",
    "uniform",
    "verdict",
    "with_values",
]

def analyse(*source: Source, whole: bool = ..., schemes: str | Sequence[str] = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ...) -> Analysis: ...

def backlash(*source: Source, quick: bool = ..., schemes: str | Sequence[str] = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ...) -> BacklashOutcome: ...

def check(file: str | File, *, machine: str | Machine | None = ..., planner: str | None = ..., dialect: str | None = ..., block_delete: bool = ..., tools: str | File | None = ..., zero: str | None = ..., most_moves: int | None = ...) -> Checked: ...

def circle(*logs: str | File | Log, tolerance: str | None = ..., radius: str | None = ..., feed: str | None = ..., pitch: str | None = ..., axes: str | Sequence[str] = ..., machine: str | Machine | None = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> CircleTest: ...

class _Commission:
    def __call__(self, ini: str | File, hal: str | File, *, log: str | File | Log | Sequence[str | File | Log] = ..., program: str | File | None = ..., drive: str = ..., seed: int = ..., gain_margin: float = ..., phase_margin: float = ..., window: str | Sequence[str] = ...) -> Commissioned: ...
    def log(self, log: str | File | Log, *, axis: str | None = ..., for_: str = ..., proportional: bool = ..., gain: str | None = ..., lead: str | None = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> LogCommissioned: ...
    def relay(self, log: str | File | Log, *, axis: str | None = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> RelayCommissioned: ...

commission: _Commission

def export(*source: Source, to: str, machine: str | None = ..., scheme: str | None = ..., axis: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ...) -> Exported: ...

def identify(*logs: str | File | Log, model: str | None = ..., axis: str | None = ..., gain: str | None = ..., full_scale: str | None = ..., cutoff: str | None = ..., slowest: str | None = ..., decimation: int | None = ..., validation: str | File | Log | None = ..., position_gain: str | None = ..., velocity_gain: str | None = ..., lead: str | None = ..., motor_inertia: str | None = ..., side: str = ..., excitation: str = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> Identification: ...

def interpolate(file: str | File, *, pitch: str = ..., resolution: str = ..., columns: str | None = ..., reference: str | None = ..., forgetting: float | None = ...) -> Interpolated: ...

def limits(file: str | File | Log, *, machine: str | Machine | None = ..., velocity: str | None = ..., acceleration: str | None = ..., jerk: str | None = ..., tolerance: str | None = ..., program: str | File | None = ..., line_column: str | None = ..., planner: str | None = ..., dialect: str | None = ..., block_delete: bool = ..., tools: str | File | None = ..., zero: str | None = ..., most_moves: int | None = ..., axes: str | Sequence[str] = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> LimitTest: ...

def link(*source: Source, vary: str | Sequence[str] = ..., axes: str | Sequence[str] = ..., figure: str = ..., tolerance: str | None = ..., extrapolate: bool = ..., seeds: int | None = ..., quick: bool = ..., division: str | Sequence[str] = ..., ways: str | Sequence[str] = ..., within: str | None = ..., message_period: str | None = ..., delay: str | None = ..., jitter: str | None = ..., loss: str | None = ..., longest: str | None = ..., schemes: str | Sequence[str] = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ...) -> LinkResult: ...

def compare(*files: Any, program: str | File | None = ..., tolerance: str | None = ..., trials: int | None = ..., schemes: str | Sequence[str] = ..., machine: str | None = ..., judge: str | None = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ..., interval: bool | None = ...) -> Runs | MeasuredRuns: ...

def measure(log: str | File | Log, *, program: str | File | None = ..., reference: str | None = ..., shift: str | None = ..., axes: str | Sequence[str] = ..., tolerance: str | None = ..., machine: str | Machine | None = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> MeasuredRuns: ...

def notch(*source: Source, log: str | File | Log | None = ..., scheme: str | None = ..., axes: str | Sequence[str] = ..., gain_margin: float = ..., phase_margin: float = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> Notched: ...

def precompensate(part: str | File, *, log: str | File | Log | Sequence[str | File | Log] = ..., passes: str | File | None = ..., machine: str | None = ..., controller: str | None = ..., repeat: int = ..., tolerance: str = ..., cap: str = ..., lead_in: bool = ..., band: str = ..., seed: int = ..., plugin: str | File | Sequence[str | File] = ..., planner: str | None = ..., dialect: str | None = ..., block_delete: bool = ..., tools: str | File | None = ..., zero: str | None = ..., most_moves: int | None = ..., axes: str | Sequence[str] = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ..., window: str | Sequence[str] = ...) -> Precompensated: ...

def record(ini: str | File) -> Recording: ...

def refine(*source: Source, window: str | Sequence[str] = ..., log: str | File | Log | Sequence[str | File | Log], parameter: str | Sequence[str], also: str | Sequence[str] = ..., validation: str | File | Log | None = ..., starts: int = ..., plugin: str | File | Sequence[str | File] = ..., column: str | Sequence[str] = ..., columns: str | File | None = ..., format: str | None = ..., period: str | None = ..., unit: str | None = ...) -> Refinement: ...

@overload
def learn(*source: str | File | Scenario, table: str | File | None = ..., trials: int | None = ..., schemes: str | Sequence[str] = ..., machine: str | None = ..., judge: str | None = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ..., interval: bool | None = ...) -> Runs: ...

@overload
def learn(machine: Machine, controller: Controller, reference: Reference, law: LearningLaw, *, trials: int = ..., seed: int = ..., start: LearnedTable | None = ..., stopping: Stopping | None = ..., part: Part = ..., jit: bool | None = ..., view: PathView | None = ..., progress: Callable[[int], None] | None = ..., on_trial: Callable[[TrialFigures], None] | None = ...) -> LearningRun: ...

def run(*source: Source, check: bool = ..., controller: str | None = ..., tolerance: str | None = ..., fit: bool = ..., no_require_end: bool = ..., dialect: str | None = ..., planner: str | None = ..., machine: str | None = ..., judge: str | None = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ..., block_delete: bool = ..., tools: str | File | None = ..., zero: str | None = ..., most_moves: int | None = ..., interval: bool | None = ...) -> Runs | Planned: ...

def sensitivity(*source: Source, width: float = ..., scheme: str = ..., distribution: str = ..., deviation: str | Sequence[str] = ..., servo_period: str | None = ..., quick: bool = ..., figure: str = ..., parts: str | Sequence[str] = ..., values: int = ..., base: int = ..., second_order: bool = ..., trajectories: int = ..., transform: str = ..., seed: int = ..., executor: str = ..., workers: int | None = ..., parameter: str | Sequence[str] = ..., machine: str | None = ..., judge: str | None = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ...) -> Sensitivity: ...

def swap(*source: Source, within: str = ..., longest: str = ..., axis: str | Sequence[str], with_: str | Sequence[str], scheme: str | None = ..., objective: str = ..., floor: str | None = ..., local: str | Sequence[str] = ..., exhaustive: bool = ..., from_: str | Sequence[str] = ..., budget: int = ..., quick: bool = ..., region: str | Sequence[str] = ..., tolerance: str | None = ..., places: int | None = ..., linear: str | Sequence[str] = ..., division: str | Sequence[str] = ..., ways: str | Sequence[str] = ..., message_period: str | None = ..., delay: str | None = ..., jitter: str | None = ..., loss: str | None = ..., executor: str = ..., workers: int | None = ..., seed: int = ..., parameter: str | Sequence[str] = ..., width: float = ..., gain_margin: float = ..., phase_margin: float = ..., plugin: str | File | Sequence[str | File] = ...) -> SwapResult: ...

class _Sweep:
    def __call__(self, study: str | File, *, chunks: str = ..., yes: bool = ..., out: str | File = ..., machine: str | None = ..., resume: bool = ..., executor: str = ..., workers: int | None = ..., plugin: str | File | Sequence[str | File] = ...) -> SweepSummary: ...
    def optimise(self, study: str | File, *, minimise: str | Sequence[str] = ..., sampler: str = ..., trials: int = ..., batch: int = ..., out: str | File = ..., machine: str | None = ..., resume: bool = ..., executor: str = ..., workers: int | None = ..., plugin: str | File | Sequence[str | File] = ...) -> Search: ...
    def show(self, store: str | File) -> SweepSummary: ...
    def query(self, store: str | File, sql: str, *, memory: str = ..., time: str = ...) -> Rows: ...
    def worst(self, store: str | File, count: int = ..., *, figure: str = ..., rerun: int | None = ..., plugin: str | File | Sequence[str | File] = ...) -> Rows | Runs: ...
    def report(self, store: str | File, *, figure: str | None = ...) -> SweepReport: ...
    def merge(self, *stores: str | File, out: str | File) -> SweepSummary: ...
    def export(self, store: str | File, *, to: str | File) -> ExportedRows: ...

sweep: _Sweep

def tune(*source: Source, scheme: str | None = ..., method: str = ..., start: str = ..., objective: str = ..., limited: float = ..., command: float | None = ..., passes: int = ..., lanes: int = ..., plateau: str = ..., within: float = ..., budget: int = ..., starts: int = ..., executor: str = ..., workers: int | None = ..., seed: int = ..., parameter: str | Sequence[str] = ..., width: float = ..., gain_margin: float = ..., phase_margin: float = ..., controller: str | None = ..., tolerance: str | None = ..., fit: bool = ..., no_require_end: bool = ..., dialect: str | None = ..., planner: str | None = ..., machine: str | None = ..., judge: str | None = ..., set: str | Sequence[str] = ..., plugin: str | File | Sequence[str | File] = ..., block_delete: bool = ..., tools: str | File | None = ..., zero: str | None = ..., most_moves: int | None = ...) -> Calibration: ...

def reproduce(paper: str, *, log_folder: str | File | None = ..., unseen: bool = ..., log: str | File | None = ..., validation: str | File | None = ...) -> Reproduction: ...
