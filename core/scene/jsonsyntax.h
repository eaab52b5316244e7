// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QByteArray>

#include <optional>

namespace pixelplumb {

/// The first place at which a text stops being JSON (RFC 8259), in one pass that builds nothing: a
/// document of a large text takes twenty times the text's size. None where there is no fault.
std::optional<InputError> jsonSyntaxError(const QByteArray &text);

} // namespace pixelplumb
