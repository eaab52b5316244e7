// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/contest.h"

#include "core/compare/exactbounds.h"
#include "core/methods/stroketruth.h"
#include "core/oracle/truepicture.h"
#include "core/runs/undrawn.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int64_t differencesBetweenProgress = 16;

/// Thrown through the drawing when the listener cancels it.
struct Cancelled { };

class Comparer {
public:
    Comparer(const Scene &scene, const ContestOptions &options)
        : m_options(options)
        , m_contest(std::make_shared<Contest>())
    {
        m_contest->scene = scene;
        m_contest->primitives = primitivesOnSamples(scene);
    }

    std::shared_ptr<const Contest> run(const std::vector<Contender> &contenders)
    {
        const auto count = std::int64_t(contenders.size());
        for (std::int64_t i = 0; i < count; ++i) {
            tell({JobPhase::Drawing, i, count});
            draw(contenders[std::size_t(i)]);
        }
        for (std::int64_t i = 0; i < count; ++i)
            record(std::size_t(i), {JobPhase::Recording, i, count});
        m_contest->agreement = AgreementMap(m_contest->scene.frame, int(contenders.size()));
        findAgreement();
        compareCarried();
        return m_contest;
    }

private:
    void tell(const JobProgress &progress) const
    {
        if (!goesOn(m_options.progress, progress))
            throw Cancelled{};
    }

    void draw(const Contender &contender)
    {
        ContenderRun &run = m_contest->runs.emplace_back(contender, m_contest->scene.frame);
        const Primitives &all = m_contest->primitives;
        std::optional<SceneRun> &drawn = m_runs.emplace_back();
        if (contender.isTruth()) {
            const Run truth(nullptr, all, contender.settings, run.truth.view());
            for (const WrittenFrame *frame : {&run.picture, &run.truth})
                truth.draw(frame->view());
        } else {
            drawn.emplace(sceneFor(m_contest->scene, contender), all);
            drawn->draw(run.picture.view());
            drawn->drawTruth(run.truth.view());
            if (!drawn->drawsAll()) {
                run.wholeTruth.emplace(m_contest->scene.frame);
                const FrameView whole = run.wholeTruth->view();
                oracle::drawPicture(all, contender.settings,
                                    Run(nullptr, all, contender.settings, whole).shading(), whole,
                                    strokeTruthOf(contender.method));
            }
        }
        count(run);
    }

    void count(ContenderRun &run) const
    {
        const JudgedRun judged{&m_contest->primitives, nullptr, &run.picture, &run.truth, nullptr};
        forEachPixel([&](std::int64_t x, std::int64_t y) {
            run.tally.written += run.picture.isWritten(x, y) ? 1 : 0;
            run.tally.againstTruth.add(differenceAt(judged, x, y));
            run.tally.undrawn += run.isUndrawn(x, y) ? 1 : 0;
        });
    }

    /// Whether it interpolates values other than colour that the scene's triangles carry.
    bool carries(const Contender &contender) const
    {
        return !contender.isTruth() && contender.method->family == MethodFamily::Interpolation
            && !m_contest->primitives.attributes.empty();
    }

    void record(std::size_t index, const JobProgress &progress)
    {
        ContenderRun &run = m_contest->runs[index];
        const bool departs = run.tally.againstTruth.total() > 0;
        const bool isNeeded
            = departs || m_options.recorded == Recorded::All || carries(run.contender);
        if (run.contender.isTruth() || !isNeeded)
            return;
        TraceOptions recording;
        recording.progress
            = [&](const JobProgress &) { return goesOn(m_options.progress, progress); };
        run.traced = traceScene(std::move(*m_runs[index]), recording);
        if (!run.traced)
            throw Cancelled{};
        if (!departs || run.contender.settings.arithmetic == Arithmetic::Exact
            || !run.contender.method->supports(Arithmetic::Exact))
            return;
        ScanSettings exact = run.contender.settings;
        exact.arithmetic = Arithmetic::Exact;
        run.inExactArithmetic.emplace(m_contest->scene.frame);
        const FrameView frame = run.inExactArithmetic->view();
        Run(run.contender.method, m_contest->primitives, exact, frame).draw(frame);
    }

    /// Column by column, each from its lowest row.
    template <class Function>
    void forEachPixel(const Function &function) const
    {
        const FrameView window = m_contest->runs.front().picture.view();
        for (std::int64_t x = window.firstColumn; x < window.endColumn(); ++x) {
            for (std::int64_t y = window.firstRow; y < window.endRow(); ++y)
                function(x, y);
        }
    }

    void findAgreement()
    {
        std::vector<ContenderRun> &runs = m_contest->runs;
        for (ContenderRun &run : runs)
            run.tally.differsFrom.assign(runs.size(), 0);
        std::vector<QRgb> values(runs.size());
        std::int64_t found = 0;
        forEachPixel([&](std::int64_t x, std::int64_t y) {
            for (std::size_t i = 0; i < runs.size(); ++i)
                values[i] = *runs[i].picture.view().at(x, y);
            if (std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) == values.end())
                return;
            int agreeing = 0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                agreeing = std::max(agreeing, int(std::ranges::count(values, values[i])));
                for (std::size_t j = 0; j < values.size(); ++j)
                    runs[i].tally.differsFrom[j] += values[i] != values[j] ? 1 : 0;
            }
            if (found++ % differencesBetweenProgress == 0)
                tell({JobPhase::Explaining, x - m_contest->scene.frame.firstColumn,
                      m_contest->scene.frame.width});
            m_contest->agreement.set(x, y, agreeing, reasonAt(x, y));
        });
    }

    void compareCarried()
    {
        std::vector<std::shared_ptr<const TracedScene>> traced;
        for (const ContenderRun &run : m_contest->runs)
            traced.push_back(run.traced);
        m_contest->carried = carriedAgreements(traced);
    }

    Disagreement reasonAt(std::int64_t x, std::int64_t y) const
    {
        Disagreement reason = Disagreement::None;
        for (std::size_t run = 0; run < m_contest->runs.size(); ++run) {
            if (m_contest->runs[run].traced)
                reason = std::max(reason, deviationAt(m_contest->judged(run), x, y).reason);
        }
        if (reason != Disagreement::None)
            return reason;
        // Each is right by its own rule, so either the rules differ or the kinds that the methods
        // draw.
        const auto leavesOut = [x, y](const ContenderRun &run) { return run.isUndrawn(x, y); };
        if (std::ranges::any_of(m_contest->runs, leavesOut))
            return Disagreement::Undrawn;
        const auto drawsTriangles = [](const ContenderRun &run) {
            return run.contender.isTruth() || run.contender.method->draws(PrimitiveKind::Triangle);
        };
        const bool isTie = std::ranges::all_of(m_contest->runs, drawsTriangles)
            && std::ranges::any_of(m_contest->primitives.triangles,
                                   [x, y](const Triangle &triangle) {
                                       return liesOnBoundary(triangle, x, y);
                                   });
        return isTie ? Disagreement::TieRule : Disagreement::Method;
    }

    const ContestOptions &m_options;
    std::shared_ptr<Contest> m_contest;
    std::vector<std::optional<SceneRun>> m_runs; ///< none of the truth
};

QString undrawnText(const Method &method, const QStringList &primitives)
{
    return u"%1 does not draw %2, which %3 here."_s.arg(
        method.id, primitives.join(u", "_s), primitives.size() == 1 ? u"stands"_s : u"stand"_s);
}

} // namespace

JudgedRun Contest::judged(std::size_t run) const
{
    const ContenderRun &of = runs[run];
    return {&primitives, of.traced.get(), &of.picture, &of.truth,
            of.inExactArithmetic ? &*of.inExactArithmetic : nullptr};
}

std::shared_ptr<const Contest> compareContenders(const Scene &scene,
                                                 const std::vector<Contender> &contenders,
                                                 const ContestOptions &options)
{
    Q_ASSERT(contenders.size() >= fewestContenders && contenders.size() <= mostContenders);
    try {
        return Comparer(scene, options).run(contenders);
    } catch (const Cancelled &) {
        return nullptr;
    }
}

PixelComparison comparePixel(const Contest &contest, std::int64_t x, std::int64_t y)
{
    PixelComparison pixel{
        x, y, contest.agreement.agreeingAt(x, y), contest.agreement.reasonAt(x, y), {}};
    for (std::size_t i = 0; i < contest.runs.size(); ++i) {
        const ContenderRun &run = contest.runs[i];
        PixelOpinion &opinion = pixel.opinions.emplace_back();
        opinion.written = run.picture.isWritten(x, y);
        if (opinion.written)
            opinion.colour = run.picture.colourAt(x, y);
        if (run.traced) {
            const JudgedRun judged = contest.judged(i);
            opinion.deviation = deviationAt(judged, x, y);
            opinion.words = textOf(opinion.deviation, judged, x, y);
        }
        if (opinion.deviation.reason == Disagreement::None && pixel.reason == Disagreement::TieRule)
            opinion.words
                = u"matches the truth under the rule %1: the sample lies on an edge"_s.arg(
                    nameText(nameOf(run.contender.settings.fillRule)));
        if (opinion.words.isEmpty() && run.isUndrawn(x, y)) {
            const BoundaryRule rule(run.contender.settings, run.truth.view());
            opinion.words
                = undrawnText(*run.contender.method,
                              undrawnAt(contest.primitives, *run.contender.method, rule, x, y));
        }
    }
    return pixel;
}

} // namespace pixelplumb
