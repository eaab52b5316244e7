// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"
#include "core/methods/words/placenumbers.h"
#include "core/scan/interpolation/interpolationnumbers.h"

/// The names of an interpolation's channels and of the numbers made from them.
namespace pixelplumb {

/// "R_B", "N_xB".
QString withSubscript(const QString &name, const QString &subscript);
/// "a_R", "a_Nx".
QString coefficientOf(const QString &coefficient, QString name);
/// "α"; in files "alpha".
QString weightTitle(std::size_t vertex);
QString weightId(std::size_t vertex);

/// The letters of a form's walk along the edges, as the edge walks use them.
EdgeWalkNames walkNames(InterpolationForm form);

/// Between which two edges a column lies: without their names where vertices are not sorted.
NumberDescription halfNumberOf(InterpolationForm form);

} // namespace pixelplumb
