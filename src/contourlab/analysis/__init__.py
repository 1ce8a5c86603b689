"""Analysis of the loop: responses, margins and poles, sampled as it runs or in continuous time; identification of an axis; and loops with
backlash: Lyapunov functions, frequency criteria, limit cycles, exact simulation and periodic orbits, servo period."""

from contourlab.analysis.axis_backlash import axis_backlash_loop
from contourlab.analysis.axis_response import axis_response, transfer
from contourlab.analysis.circle_criterion import AbsoluteStability, circle_criterion, popov_criterion
from contourlab.analysis.common_lyapunov import CommonLyapunov, common_quadratic
from contourlab.analysis.contour_transfer import (
    ContourMargins,
    ContourTransfer,
    contour_error_transfer,
    contour_margins,
    contour_transfer,
)
from contourlab.analysis.describing_function import dead_zone_gain
from contourlab.analysis.exact_simulation import ExactRun, simulate_exact
from contourlab.analysis.identification import Estimate, SecondOrderFit, identify_delay, identify_gain, identify_second_order
from contourlab.analysis.internal_stability import InternalStability, internal_stability
from contourlab.analysis.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.learning_rules import LearningDesign, design_zero_phase
from contourlab.analysis.limit_cycle_prediction import LimitCycle, Prediction, predict_limit_cycles
from contourlab.analysis.lure import BacklashLoop
from contourlab.analysis.lure_postnikov import EnergyFunction, energy_function
from contourlab.analysis.margins import Margins, margins
from contourlab.analysis.mode_flow import Motion
from contourlab.analysis.orbit_search import OrbitSearch, find_forced_orbits, find_orbits
from contourlab.analysis.periodic_orbit import PeriodicOrbit, close_orbit
from contourlab.analysis.response import AxisResponse
from contourlab.analysis.sampled_loop import SampledLoop, sampled_loop
from contourlab.analysis.servo_period import ServoPeriodLimit, servo_period_limit
from contourlab.analysis.two_inertia_loop import Feedback, TwoInertias, motor_pid, p_pi_cascade, two_inertia_loop
from contourlab.analysis.zpetc import ZeroPhaseDesign, zpetc_design, zpetc_from_polynomials

__all__ = [
    "AbsoluteStability",
    "AxisResponse",
    "BacklashLoop",
    "CommonLyapunov",
    "ContourMargins",
    "ContourTransfer",
    "EnergyFunction",
    "Estimate",
    "ExactRun",
    "Feedback",
    "InternalStability",
    "LearningAnalysis",
    "LearningDesign",
    "LimitCycle",
    "Margins",
    "Motion",
    "OrbitSearch",
    "PeriodicOrbit",
    "Prediction",
    "SampledLoop",
    "SecondOrderFit",
    "ServoPeriodLimit",
    "TwoInertias",
    "ZeroPhaseDesign",
    "axis_backlash_loop",
    "axis_response",
    "circle_criterion",
    "close_orbit",
    "common_quadratic",
    "contour_error_transfer",
    "contour_margins",
    "contour_transfer",
    "dead_zone_gain",
    "design_zero_phase",
    "energy_function",
    "find_forced_orbits",
    "find_orbits",
    "identify_delay",
    "identify_gain",
    "identify_second_order",
    "internal_stability",
    "learning_analysis",
    "margins",
    "motor_pid",
    "p_pi_cascade",
    "popov_criterion",
    "predict_limit_cycles",
    "sampled_loop",
    "servo_period_limit",
    "simulate_exact",
    "transfer",
    "two_inertia_loop",
    "zpetc_design",
    "zpetc_from_polynomials",
]
