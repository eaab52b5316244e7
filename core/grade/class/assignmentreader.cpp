// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/defect.h"
#include "core/grade/class/assignment.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/filepath.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/choicereader.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

namespace {

const QString formatKey = u"pixelplumbAssignment"_s;
const QString sceneKey = u"pixelplumb"_s;

/// Reads the parts of an assignment from JSON; errors stay with the JsonReader.
class AssignmentReader {
public:
    AssignmentReader(JsonReader &json, const QString &folder)
        : m_json(json)
        , m_folder(folder)
    {
    }

    Assignment read()
    {
        const JsonNode &root = m_json.root();
        readFormat(root);
        m_json.expectObject(root,
                            {formatKey, "name", "hint", "leeway", "tolerance", "winding",
                             "convention", "credit", "points", "scenes", "program"});
        Assignment assignment;
        assignment.name = m_json.string(root["name"]);
        readWord(root["hint"], allHintLevels, assignment.hint);
        readWord(root["leeway"], allLeeways, assignment.margin.leeway);
        readWord(root["tolerance"], allTolerances, assignment.margin.tolerance);
        readWord(root["winding"], allWindings, m_winding);
        assignment.winding = m_winding;
        readWord(root["convention"], allConventions, assignment.convention);
        readWord(root["credit"], allCredits, assignment.credit);
        readPoints(root["points"], m_points);
        readScenes(root["scenes"], assignment.scenes);
        if (const JsonNode program = root["program"]; !program.isMissing())
            assignment.program = readProgram(program);
        const auto asksForInvariants = [](const AssignedScene &scene) {
            return scene.points[std::size_t(Check::Invariants)] > 0;
        };
        if (!assignment.program && std::ranges::any_of(assignment.scenes, asksForInvariants))
            m_json.fail(root["points"], u"points for invariants, and no “program” to be run"_s,
                        u"a “program”: invariants are asked of random triangles"_s);
        return assignment;
    }

private:
    void readFormat(const JsonNode &root)
    {
        const JsonNode format = root[formatKey];
        if (root.isObject() && !format.isMissing())
            m_json.integer(format, 1, assignmentFormat);
        else if (const JsonNode other = root[sceneKey]; !other.isMissing())
            m_json.fail(other, u"this is a scene"_s,
                        u"an assignment, by which submissions are graded"_s);
        else
            m_json.fail(format, u"no format number: this is no assignment"_s,
                        u"\"%1\": %2"_s.arg(formatKey, QString::number(assignmentFormat)));
    }

    static QString wordOf(const QString &name) { return name; }
    static QString wordOf(std::string_view name) { return nameText(name); }

    template <class Choice, std::size_t Count>
    void readWord(const JsonNode &node, const std::array<Choice, Count> &choices, Choice &choice)
    {
        if (node.isMissing())
            return;
        QStringList words;
        for (const Choice each : choices)
            words += wordOf(nameOf(each));
        const qsizetype place = words.indexOf(node.toString());
        if (place < 0)
            m_json.fail(node, describe(node), anyOf(words));
        else
            choice = choices[std::size_t(place)];
    }

    /// Missing keys keep their defaults.
    void readPoints(const JsonNode &node, CheckPoints &points)
    {
        if (node.isMissing())
            return;
        QStringList names;
        for (const Check check : allChecks)
            names += nameOf(check);
        m_json.expectObject(node, names);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const JsonNode each = node[names[qsizetype(i)]];
            if (each.isMissing())
                continue;
            points[i] = each.toDouble(-1);
            if (!(points[i] >= 0 && points[i] <= largestPoints))
                m_json.fail(each, describe(each),
                            u"a number from 0 to %1"_s.arg(largestPoints, 0, 'f', 0));
        }
    }

    void readScenes(const JsonNode &node, std::vector<AssignedScene> &scenes)
    {
        const std::vector<JsonNode> nodes = m_json.array(node);
        if (nodes.empty())
            m_json.fail(node, describe(node), u"one scene at least"_s);
        for (const JsonNode &each : nodes) {
            if (m_json.hasFailed())
                return;
            scenes.push_back(readScene(each, scenes));
        }
    }

    AssignedScene readScene(const JsonNode &node, const std::vector<AssignedScene> &before)
    {
        const JsonNode name = node["name"];
        const JsonNode content = node["scene"];
        m_json.expectObject(node, {"name", "scene", "points"});
        AssignedScene scene;
        scene.name = m_json.string(name);
        static const QRegularExpression plain(u"\\A[A-Za-z0-9_-]{1,64}\\z"_s);
        if (!plain.match(scene.name).hasMatch())
            m_json.fail(name, describe(name),
                        u"1 to 64 letters, digits, - and _, of which a picture's "
                        "file has its name"_s);
        const bool isTaken = std::ranges::any_of(before, [&](const AssignedScene &other) {
            return other.name.compare(scene.name, Qt::CaseInsensitive) == 0;
        });
        if (isTaken)
            m_json.fail(name, u"%1 is a scene's already"_s.arg(describe(name)),
                        u"a name for each"_s);
        scene.points = m_points;
        readPoints(node["points"], scene.points);
        readContent(content, scene.scene);
        checkWinding(content, scene.scene);
        return scene;
    }

    void checkWinding(const JsonNode &node, const Scene &scene)
    {
        for (std::size_t i = 0; i < scene.triangles.size() && !m_json.hasFailed(); ++i) {
            if (!windsOtherwise(scene.triangles[i], m_winding, scene.frame.origin))
                continue;
            m_json.fail(node,
                        u"triangle %1, counted from 0, is not %2"_s.arg(QString::number(i),
                                                                        nameOf(m_winding)),
                        u"what “winding” promises: exchange two of its vertices"_s);
        }
    }

    void readContent(const JsonNode &node, Scene &scene)
    {
        if (m_json.hasFailed())
            return;
        if (node.isObject()) {
            scene = pixelplumb::readScene(m_json, node, m_folder);
        } else if (const QString file = m_json.string(node); !m_json.hasFailed()) {
            if (const auto reading = readSceneFile(QDir(m_folder).filePath(filePath(file))))
                scene = reading->scene;
            else
                m_json.fail(node, reading.error().message(),
                            u"a scene, or the name of a scene's file"_s);
        }
        if (m_json.hasFailed())
            return;
        if (const QString objection = objectionTo(scene); !objection.isEmpty())
            m_json.fail(
                node, u"method “%1” %2"_s.arg(QString::fromStdString(scene.method), objection), {});
        else if (undoEachOther(scene.settings.variants))
            m_json.fail(node, undoingText(), u"one of them, or none"_s);
        else if (!drawsAnyOf(scene))
            m_json.fail(node,
                        u"method “%1” draws none of the primitives"_s.arg(
                            QString::fromStdString(scene.method)),
                        u"a method that draws one"_s);
    }

    AssignedProgram readProgram(const JsonNode &node)
    {
        m_json.expectObject(node, {"file", "input", "seconds", "megabytes", "outputMegabytes"});
        AssignedProgram program;
        if (const JsonNode name = node["file"]; !name.isMissing()) {
            program.file = m_json.string(name);
            if (program.file.isEmpty() || program.file.contains(u'/')
                || program.file.startsWith(u'.'))
                m_json.fail(name, describe(name), u"a file's name, without folders"_s);
        }
        readWord(node["input"], allProgramInputs, program.input);
        readNumber(node["seconds"], {1, 3600}, program.seconds);
        if (const JsonNode memory = node["megabytes"]; memory.toDouble(-1) == 0)
            m_json.fail(memory, u"0: a class' programs may not have all memory"_s,
                        u"%1 to %2; a runtime that reserves much, such as Java's or "
                        "Go's, has enough of 65536"_s.arg(leastMegabytes)
                            .arg(mostMegabytes));
        readNumber(node["megabytes"], {leastMegabytes, mostMegabytes}, program.megabytes);
        readNumber(node["outputMegabytes"], {1, 1024}, program.outputMegabytes);
        return program;
    }

    void readNumber(const JsonNode &node, std::pair<int, int> range, int &number)
    {
        if (!node.isMissing())
            number = int(m_json.integer(node, range.first, range.second));
    }

    JsonReader &m_json;
    QString m_folder;
    Winding m_winding = Winding::Any;
    CheckPoints m_points = AssignedScene().points; ///< for scenes without their own
};

} // namespace

Result<Assignment> readAssignment(const QByteArray &text, const QString &folder)
{
    JsonReader json(text);
    if (json.hasFailed())
        return json.error();
    Assignment assignment = AssignmentReader(json, folder).read();
    if (json.hasFailed())
        return json.error();
    return assignment;
}

FileKind kindOfFile(const QString &path)
{
    const Result<QByteArray> text = readRegularFile(path, shortText);
    if (!text)
        return FileKind::Other;
    const JsonReader json(*text);
    if (json.hasFailed() || !json.root().isObject())
        return FileKind::Other;
    if (!json.root()[formatKey].isMissing())
        return FileKind::Assignment;
    return json.root()[sceneKey].isMissing() ? FileKind::Other : FileKind::Scene;
}

Result<Assignment> assignmentOf(const Scene &scene, const QString &name)
{
    Assignment assignment;
    assignment.name = name;
    assignment.scenes.push_back({u"task"_s, scene});
    return readAssignment(writeAssignment(assignment));
}

Result<Assignment> readAssignmentFile(const QString &path)
{
    const Result<QByteArray> text = readRegularFile(path);
    if (!text)
        return text.error();
    Result<Assignment> assignment = readAssignment(*text, QFileInfo(filePath(path)).absolutePath());
    if (assignment)
        return assignment;
    return errorIn(path, assignment.error());
}

} // namespace pixelplumb
