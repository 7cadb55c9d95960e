// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/estimator_entry.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// How the boundary elements of `fe-be` stand to finite elements of degree p.
  enum class BoundarySolution
  {
    trace_space,         ///< displacements and discontinuous tractions of degree p, recovered du/ds
    constant_traction,   ///< displacements of degree p, tractions of degree p - 1: the paper to the letter
    reference_quality,   ///< displacements of degree p + 1, tractions of degree p
    finite_element_trace ///< no boundary elements are solved: displacements and reactions of finite elements
  };

  /// How the estimated stress error of a cell is related to the mean stress of its body.
  enum class Normalisation
  {
    rms,    ///< root of mean squares: a relative stress error
    printed ///< norm by area, (27) of the paper to the letter
  };

  /// The sentence on boundary elements of which no bound is made.
  constexpr const char *coarse_boundary_elements = "these boundary elements (Boundary solution) are no "
                                                   "better than the finite elements where the stress is "
                                                   "large";

  /// What the section `Adaptation` says.
  struct AdaptationParameters
  {
    std::string estimator = "none"; ///< a word with an EstimatorEntry
    BoundarySolution boundary_solution = BoundarySolution::trace_space;
    double boundary_accuracy = 1e-3; ///< of fast boundary elements, as a share of the estimate; 0: none
    Normalisation normalisation = Normalisation::rms;
    double limit = 0.;                ///< delta: the run ends when eta is below it in every cell; 0: no limit
    std::string marking = "doerfler"; ///< a word with a MarkingEntry
    double fraction = .5;   ///< fixed fraction: of the cells; Doerfler: theta^2, of the squared error
    double coarsening = 0.; ///< see the parameter's documentation; 0: no cell is merged
    unsigned int maximum_passes = 10;
    unsigned int maximum_unknowns = 1000000;
    double iteration_fraction = .1;  ///< iteration error allowed, by the discretisation error
    unsigned int estimate_steps = 0; ///< estimate at every n-th step too (fe-be); 0: at the end of a pass
    bool combined = false;           ///< one decomposition step and one adaptation step a pass

    /// Why the estimate does not refer to the pressures that the contact law makes of the displacement, so
    /// that it tells of discretisation and iteration together: one sentence, without the full stop. Empty
    /// where it does, with boundary elements. Else it refers to the pressures that the displacement answers;
    /// also in the combined algorithm, as in the paper.
    std::string why_not_by_law() const;
    /// `Estimator = automatic`.
    bool certifies() const;
    bool estimates_by_law() const { return why_not_by_law().empty(); }

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static AdaptationParameters parse(dealii::ParameterHandler &prm);
  };

  /// Their names, for messages.
  std::string estimators_with_boundary_elements();
} // namespace abut
