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
    QJsonObject object{{QStringLiteral("input"), nameOf(program.input)},
                       {QStringLiteral("seconds"), program.seconds},
                       {QStringLiteral("megabytes"), program.megabytes},
                       {QStringLiteral("outputMegabytes"), program.outputMegabytes}};
    if (!program.file.isEmpty())
        object.insert(QStringLiteral("file"), program.file);
    return object;
}

} // namespace

QString nameOf(Check check)
{
    switch (check) {
    case Check::Picture:
        return QStringLiteral("picture");
    case Check::Coverage:
        return QStringLiteral("coverage");
    case Check::Colours:
        return QStringLiteral("colours");
    case Check::Invariants:
        break;
    }
    return QStringLiteral("invariants");
}

QString nameOf(HintLevel level)
{
    switch (level) {
    case HintLevel::Class:
        return QStringLiteral("class");
    case HintLevel::Hint:
        return QStringLiteral("hint");
    case HintLevel::Pixels:
        return QStringLiteral("pixels");
    case HintLevel::Full:
        break;
    }
    return QStringLiteral("full");
}

QString nameOf(Winding winding)
{
    switch (winding) {
    case Winding::Any:
        return QStringLiteral("any");
    case Winding::CounterClockwise:
        return QStringLiteral("counter-clockwise");
    case Winding::Clockwise:
        break;
    }
    return QStringLiteral("clockwise");
}

QString nameOf(Credit credit)
{
    return credit == Credit::Whole ? QStringLiteral("whole") : QStringLiteral("share");
}

QString nameOf(ProgramInput input)
{
    return input == ProgramInput::Json ? QStringLiteral("json") : QStringLiteral("lines");
}

QString nameOf(Convention convention)
{
    return convention == Convention::Asked ? QStringLiteral("asked") : QStringLiteral("any");
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
        scenes.append(QJsonObject{
            {QStringLiteral("name"), each.name},
            {QStringLiteral("points"), assignedJson(each.points)},
            {QStringLiteral("scene"), QJsonDocument::fromJson(writeScene(each.scene)).object()}});
    QJsonObject object{{QStringLiteral("pixelplumbAssignment"), assignmentFormat},
                       {QStringLiteral("name"), assignment.name},
                       {QStringLiteral("hint"), nameOf(assignment.hint)},
                       {QStringLiteral("leeway"), nameText(nameOf(assignment.margin.leeway))},
                       {QStringLiteral("tolerance"), nameText(nameOf(assignment.margin.tolerance))},
                       {QStringLiteral("winding"), nameOf(assignment.winding)},
                       {QStringLiteral("convention"), nameOf(assignment.convention)},
                       {QStringLiteral("credit"), nameOf(assignment.credit)},
                       {QStringLiteral("scenes"), scenes}};
    if (assignment.program)
        object.insert(QStringLiteral("program"), assignedJson(*assignment.program));
    return escapedJson(QJsonDocument(object).toJson());
}

} // namespace pixelplumb
