// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

class Canvas;
class DisplayOptions;
class EffectSwitches;
class MessageBar;
class OverdrawOverlay;
class Playhead;
class RecentFiles;
class SceneDocument;
class SceneExports;
class SceneFiles;
class ScenePreviewer;
class SceneTracer;
class Scrubber;
class StepActions;
class StudentPicture;
class StudentPictureFiles;

/// The window's parts, for code that connects menus to them. The window owns them all.
struct WindowParts {
    SceneDocument *document = nullptr;
    Playhead *playhead = nullptr;
    DisplayOptions *options = nullptr;
    EffectSwitches *effects = nullptr;
    SceneTracer *tracer = nullptr;
    ScenePreviewer *previewer = nullptr;
    RecentFiles *recent = nullptr;
    SceneFiles *files = nullptr;
    SceneExports *exports = nullptr;
    StudentPicture *student = nullptr;
    StudentPictureFiles *pictures = nullptr;
    StepActions *steps = nullptr;
    Canvas *canvas = nullptr;
    OverdrawOverlay *overdraw = nullptr;
    Scrubber *scrubber = nullptr;
    MessageBar *messageBar = nullptr;
};

} // namespace pixelplumb
