// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

/// The object names that design and README promise to programs.
namespace pixelplumb {

inline const QStringList promisedWidgets{
    "canvas",           "columnTable",        "pixelGrid",        "formulaPanel",
    "pixelHistory",     "stepperBar",         "scrubber",         "methodBox",
    "arithmeticBox",    "fillRuleBox",        "roundingBox",      "unitBox",
    "speedSlider",      "speedBox",           "positionLabel",    "messageBar",
    "traceProgress",    "cancelTrace",        "statusPixel",      "statusColumn",
    "statusStep",       "statusSettings",     "formulaDock",      "pixelGridDock",
    "pixelHistoryDock", "columnsDock",        "nextColourButton", "compare",
    "compareDock",      "agreementMap",       "compareReason",    "hardCases",
    "hardCasesDock",    "precision",          "precisionDock",    "precisionPlot",
    "overdrawMap",      "performance",        "performanceDock",  "loadProgress",
    "cancelLoad",       "saveProgress",       "exportProgress",   "cancelExport",
    "operations",       "operationTable",     "operationsDock",   "statusFigures",
    "accuracyLab",      "accuracyLabDock",    "labInvitation",    "labRun",
    "labExtent",        "labCancel",          "labProgress",      "labFamily",
    "labError",         "labShown",           "labFiles",         "labTabs",
    "labPrice",         "labPareto",          "labTable",         "labAnswers",
    "labMisses",        "labMissContender",   "labCostStack",     "labScaling",
    "labSizeAxis",      "labDrift",           "labEffects",       "labChanges",
    "labWarnings",      "labConditions",      "projectionPanel",  "projectionDock",
    "projectionTabs",   "projectionSentence", "sideView",         "stageTree",
    "surfacesPanel",    "surfaceForms",       "surfaceS",         "surfaceT",
    "segmentTable",     "effectsPanel",       "effectsDock",      "effectsTable",
    "effectsSummary",   "effectsMeasure",     "effectsCancel",    "methodPanel",
    "methodText",       "methodDock",         "predict",          "predictChoice",
    "predictQuestion",  "predictAnswer",      "predictCheck",     "predictShow",
    "predictNext",      "predictVerdict",     "predictScore",     "predictDock",
    "motion",           "motionDock",         "motionX",          "motionY",
    "motionFrames",     "motionSet",          "motionEnd",        "motionSlider",
    "motionPlay",       "motionPosition",     "motionSummary",    "motionView",
    "motionTable",      "primitives",         "primitivesDock",   "primitivesTree",
    "rowFilterBox",     "layersMenu"};

/// Of the lab's menu of files; those of the menus have names that tests find in the menus.
inline const QStringList promisedActions{"labOpen",        "labEarlier", "labSave",
                                         "labSaveTable",   "labCompare", "labSaveChart",
                                         "labCopyCommand", "copyTable"};

inline const QStringList promisedDialogs{
    "frameDialog",   "triangleDialog", "vertexDialog",   "goToDialog",    "rasterDialog",
    "keySheet",      "unsavedChanges", "savingDialog",   "saveDialog",    "exportDialog",
    "labOpenDialog", "labSaveDialog",  "examplesDialog", "recoveryDialog"};

} // namespace pixelplumb
