// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/scene/text/result.h"
#include "core/space/solid.h"

namespace pixelplumb {

/// Reads the triangles of a Wavefront OBJ file: its v, vt, vn and f lines; a face with more corners
/// becomes a fan. Everything else in the file (groups, materials, lines) is skipped.
/// The listener hears now and then how many bytes are read; when it ends the reading, an error says
/// so.
Result<Mesh> readMesh(const QString &path, const ProgressListener &listener = {});

/// Like readMesh(), from the file's content; `name` stands for the file in messages.
Result<Mesh> parseMesh(QByteArray text, const QString &name, const ProgressListener &listener = {});

} // namespace pixelplumb
