// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/assignment.h"

#include "core/grade/showntext.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <numeric>

namespace pixelplumb {

namespace {

QJsonObject assignedJson(const CheckPoints &points)
{
    QJsonObject object;
    for (std::size_t i = 0; i < points.size(); ++i)
        object.insert(nameOf(allChecks[i]), points[i]);
    return object;
}

QJsonObject assignedJson(const AssignedProgram &program)
{
    QJsonObject object{{u"input"_s, nameOf(program.input)},
                       {u"seconds"_s, program.seconds},
                       {u"megabytes"_s, program.megabytes},
                       {u"outputMegabytes"_s, program.outputMegabytes}};
    if (!program.file.isEmpty())
        object.insert(u"file"_s, program.file);
    return object;
}

} // namespace

QString nameOf(Check check)
{
    switch (check) {
    case Check::Picture:
        return u"picture"_s;
    case Check::Coverage:
        return u"coverage"_s;
    case Check::Colours:
        return u"colours"_s;
    case Check::Invariants:
        break;
    }
    return u"invariants"_s;
}

QString nameOf(HintLevel level)
{
    switch (level) {
    case HintLevel::Class:
        return u"class"_s;
    case HintLevel::Hint:
        return u"hint"_s;
    case HintLevel::Pixels:
        return u"pixels"_s;
    case HintLevel::Full:
        break;
    }
    return u"full"_s;
}

QString nameOf(Winding winding)
{
    switch (winding) {
    case Winding::Any:
        return u"any"_s;
    case Winding::CounterClockwise:
        return u"counter-clockwise"_s;
    case Winding::Clockwise:
        break;
    }
    return u"clockwise"_s;
}

QString nameOf(Credit credit) { return credit == Credit::Whole ? u"whole"_s : u"share"_s; }

QString nameOf(ProgramInput input) { return input == ProgramInput::Json ? u"json"_s : u"lines"_s; }

QString nameOf(Convention convention)
{
    return convention == Convention::Asked ? u"asked"_s : u"any"_s;
}

bool windsOtherwise(const Triangle &triangle, Winding winding, FrameOrigin origin)
{
    if (winding == Winding::Any)
        return false;
    const Int128 area = doubledArea(triangle);
    const bool isUpward = origin == FrameOrigin::BottomLeft;
    return (winding == Winding::Clockwise) == isUpward ? area > 0 : area < 0;
}

double Assignment::points() const
{
    double sum = 0;
    for (const AssignedScene &scene : scenes)
        sum = std::accumulate(scene.points.begin(), scene.points.end(), sum);
    return sum;
}

QByteArray writeAssignment(const Assignment &assignment)
{
    QJsonArray scenes;
    for (const AssignedScene &each : assignment.scenes)
        scenes.append(
            QJsonObject{{u"name"_s, each.name},
                        {u"points"_s, assignedJson(each.points)},
                        {u"scene"_s, QJsonDocument::fromJson(writeScene(each.scene)).object()}});
    QJsonObject object{{u"pixelplumbAssignment"_s, assignmentFormat},
                       {u"name"_s, assignment.name},
                       {u"hint"_s, nameOf(assignment.hint)},
                       {u"leeway"_s, nameText(nameOf(assignment.margin.leeway))},
                       {u"tolerance"_s, nameText(nameOf(assignment.margin.tolerance))},
                       {u"winding"_s, nameOf(assignment.winding)},
                       {u"convention"_s, nameOf(assignment.convention)},
                       {u"credit"_s, nameOf(assignment.credit)},
                       {u"scenes"_s, scenes}};
    if (assignment.program)
        object.insert(u"program"_s, assignedJson(*assignment.program));
    return escapedJson(QJsonDocument(object).toJson());
}

} // namespace pixelplumb
