// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

/// Gives the window's parts, actions and menus their What's This texts: one to three sentences, by
/// the part's object name; a part without a sentence gets its current tool tip. Menus explain
/// entries that have neither.
void explainParts(QWidget *window);

/// A page of the manual: each panel with its workspace, its key and its explanation.
QString panelsHtml(const QWidget *window);

/// Enters What's This mode: the next click explains what it hits instead of acting.
void enterWhatsThis(QWidget *window);

} // namespace pixelplumb
