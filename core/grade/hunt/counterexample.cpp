// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/counterexample.h"

#include "core/geometry/seededrandom.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/scan/redrawing.h"
#include "core/grade/showntext.h"
#include "core/grade/try/studentoutput.h"
#include "core/runs/scenerun.h"
#include "core/scene/scenefile.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace pixelplumb {

namespace {

/// How large and how simple random scenes are.
struct Growth {
    int side = 0; ///< px
    int denominator = 1; ///< of coordinates
    bool isOfOneColour = true;
    int primitives = 1;
};

std::vector<Growth> growths()
{
    std::vector<Growth> all;
    for (const int primitives : {1, 2}) {
        for (const int side : {3, 4, 5, 6, 8, 12, 16, 24, 32, 48, 64}) {
            for (const int denominator : {1, 2, 16, 256}) {
                for (const bool isOfOneColour : {true, false})
                    all.push_back({side, denominator, isOfOneColour, primitives});
            }
        }
    }
    return all;
}
constexpr int triesOfMethods = 60; // for each growth
constexpr int triesOfPrograms = 6;
constexpr std::int64_t mostUndrawn = 100; // in a row from the start

Scene grownScene(const Scene &conventions, const Growth &growth, SeededRandom &random)
{
    Scene scene = conventions;
    const Lattice unit = unitsPerPixel / growth.denominator;
    const auto vertex = [&] {
        const auto coordinate = [&] {
            return random.between(0, std::int64_t(growth.side - 1) * growth.denominator) * unit;
        };
        Vertex made{{coordinate(), coordinate()}, {{255, 255, 255}}};
        if (!growth.isOfOneColour)
            made.colour = random.colour();
        return made;
    };
    const Method &method = *methodNamed(QString::fromStdString(conventions.method));
    const bool isOfTriangles = method.draws(PrimitiveKind::Triangle);
    for (int i = 0; i < growth.primitives; ++i) {
        if (isOfTriangles) {
            Triangle triangle{{vertex(), vertex(), vertex()}};
            if (i > 0) { // the second shares an edge with the first, the other way round
                triangle.vertices[0] = scene.triangles.back().vertices[1];
                triangle.vertices[1] = scene.triangles.back().vertices[0];
            }
            scene.triangles.push_back(triangle);
        } else {
            Shape line;
            line.vertices = {vertex(), vertex()};
            scene.shapes.push_back(line);
        }
    }
    return scene;
}

/// The smallest frame from (0, 0) that holds all vertices and the samples around them.
void fitFrame(Scene &scene)
{
    Lattice right = 0;
    Lattice top = 0;
    const auto include = [&](const Vertex &vertex) {
        right = std::max(right, vertex.position.x);
        top = std::max(top, vertex.position.y);
    };
    for (const Triangle &triangle : scene.triangles)
        std::ranges::for_each(triangle.vertices, include);
    for (const Shape &shape : scene.shapes)
        std::ranges::for_each(shape.vertices, include);
    scene.frame.width = int(ceilPixel(right)) + 1;
    scene.frame.height = int(ceilPixel(top)) + 1;
    scene.frame.firstColumn = 0;
    scene.frame.firstRow = 0;
}

bool hasDegenerate(const Scene &scene)
{
    return std::ranges::any_of(scene.triangles,
                               [](const Triangle &triangle) { return doubledArea(triangle) == 0; })
        || std::ranges::any_of(scene.shapes, [](const Shape &shape) {
               return shape.vertices.front().position == shape.vertices.back().position;
           });
}

} // namespace

PictureSource sourceOf(const Contender &contender)
{
    const auto sceneOf = [contender](const Scene &scene) {
        Scene drawn = sceneFor(scene, contender);
        drawn.settings = contender.settings;
        return drawn;
    };
    if (contender.isTruth())
        return {contender.name(), [sceneOf](const Scene &scene) -> Result<Picture> {
                    return truePictureOf(sceneOf(scene));
                }};
    return {contender.name(),
            [sceneOf](const Scene &scene) -> Result<Picture> {
                const Scene drawn = sceneOf(scene);
                if (const QString objection = objectionTo(drawn); !objection.isEmpty())
                    return InputError{{}, objection, {}};
                return pictureOf(drawn);
            },
            [sceneOf](const Scene &scene) -> std::optional<DefectiveScene> {
                return DefectiveScene{sceneOf(scene)};
            },
            contender.method->isStableUnder(contender.settings)};
}

namespace {

/// A redrawing is the same defect in every scene of its conventions that can be redrawn. It is
/// looked up once, since listing all defects takes longer than drawing a small scene.
class FoundRedrawing {
public:
    std::optional<Defect> in(const Scene &scene) const
    {
        const std::lock_guard lock(m_mutex);
        return m_defect && canBeRedrawn(scene) ? m_defect : std::nullopt;
    }
    Defect keep(Defect defect)
    {
        const std::lock_guard lock(m_mutex);
        if (defect.redrawing)
            m_defect = defect;
        return defect;
    }

private:
    mutable std::mutex m_mutex;
    std::optional<Defect> m_defect;
};

} // namespace

PictureSource sourceOf(const QString &defect, const Contender &of)
{
    const auto redrawing = std::make_shared<FoundRedrawing>();
    const auto defectIn = [defect, redrawing](const Scene &scene) -> std::optional<Defect> {
        if (const auto before = redrawing->in(scene))
            return before;
        for (Defect &known : defectsFor(scene)) {
            if (known.id == defect)
                return redrawing->keep(std::move(known));
        }
        return std::nullopt;
    };
    return {of.name() + u" with "_s + defect,
            [=](const Scene &scene) -> Result<Picture> {
                const Scene right = sceneFor(scene, of);
                const auto found = defectIn(right);
                return found ? pictureWith(right, std::span(&*found, 1)) : pictureOf(right);
            },
            [=](const Scene &scene) -> std::optional<DefectiveScene> {
                const Scene right = sceneFor(scene, of);
                const auto found = defectIn(right);
                if (!found)
                    return std::nullopt;
                return DefectiveScene{right, {*found}};
            }};
}

namespace {

/// How the run ended, and its last line on stderr.
QString endText(const StudentRun &run)
{
    const QString said = shownText(run.messages).trimmed();
    return said.isEmpty() ? run.told : run.told + u": "_s + said.section(u'\n', -1);
}

} // namespace

PictureSource sourceOf(const StudentProgram &student, const TrialTerms &terms)
{
    return {student.path,
            [student, terms](const Scene &scene) -> Result<Picture> {
                const Result<StudentRun> run = runOn(student, scene, terms);
                if (!run)
                    return run.error();
                if (run->end != ProgramEnd::Finished)
                    return InputError{{}, endText(*run), {}};
                Result<StudentOutput> output = readStudentOutput(run->output, scene);
                if (!output)
                    return output.error();
                if (!output->picture)
                    return InputError{u"the output"_s, u"a trace without lines of pixels"_s,
                                      u"a picture, or a line a pixel"_s};
                return std::move(*output->picture);
            },
            {},
            false,
            true};
}

SceneTrial tryScene(const PictureSource &one, const PictureSource &other, Scene scene)
{
    if (hasDegenerate(scene))
        return {SceneOutcome::Degenerate, {}};
    fitFrame(scene);
    const auto undrawn = [&scene](const PictureSource &source, const InputError &why) {
        return SceneTrial{SceneOutcome::Undrawn, {}, UndrawnScene{scene, source.name, why}};
    };
    auto pictureOfOne = one.draw(scene);
    if (!pictureOfOne)
        return undrawn(one, pictureOfOne.error());
    auto pictureOfOther = other.draw(scene);
    if (!pictureOfOther)
        return undrawn(other, pictureOfOther.error());
    if (differingPixels(*pictureOfOne, *pictureOfOther, 1) == 0)
        return {};
    return {SceneOutcome::Different,
            CounterExample{std::move(scene), std::move(*pictureOfOne), std::move(*pictureOfOther)}};
}

CounterSearch findCounterExample(const PictureSource &one, const PictureSource &other,
                                 const Scene &conventions, std::uint64_t seed,
                                 const ProgressListener &listener)
{
    const int triesEach = one.isProgram || other.isProgram ? triesOfPrograms : triesOfMethods;
    SeededRandom random(seed);
    CounterSearch search;
    const std::vector<Growth> all = growths();
    const std::int64_t most = std::ssize(all) * triesEach;
    for (const Growth &growth : all) {
        for (int i = 0; i < triesEach; ++i) {
            ++search.tried;
            SceneTrial trial = tryScene(one, other, grownScene(conventions, growth, random));
            if (trial.undrawn) {
                ++search.undrawn;
                if (!search.firstUndrawn)
                    search.firstUndrawn = std::move(trial.undrawn);
            }
            search.compared += trial.outcome == SceneOutcome::Same || trial.example ? 1 : 0;
            if (search.compared == 0 && search.undrawn == mostUndrawn)
                return search;
            if (trial.example) {
                search.found = shrunk(std::move(*trial.example), one, other, listener);
                return search;
            }
            if (!goesOn(listener, {JobPhase::Judging, search.tried, most})) {
                search.wasEnded = true;
                return search;
            }
        }
    }
    return search;
}

} // namespace pixelplumb
