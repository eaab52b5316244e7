// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace pixelplumb {

/// Gives the window's parts, actions and menus their What's This texts: one to three sentences, by
/// the part's object name; what has no sentence of its own has its tool tip, as it is now. Menus
/// explain those of their entries that have neither.
void explainParts(QWidget *window);

/// Then the next click tells what it hits instead of doing it.
void enterWhatsThis(QWidget *window);

} // namespace pixelplumb
