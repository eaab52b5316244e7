// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"
#include "core/methods/words/pseudocode.h"

namespace pixelplumb {

/// What decides which samples a walk covers.
enum class WalkCoverage {
    AsComputed, ///< the bounds in the walk's own arithmetic, which may depart or cross
    Exact, ///< exact bounds; vertices may be named as they are given
};

/// What a walk carries beside the coordinate: its lines say which, the runs of a listing with
/// effects which of them are carried.
enum class WalkValues { Colours, Carried };

/// The listing of a walk between two edges. A test runs every line: L_ij is the current short edge,
/// whose digits take the place of i and j; y becomes R, and m δR, where R is done "likewise".
class WalkListing {
public:
    WalkListing(const EdgeWalkForm &form, WalkCoverage coverage,
                WalkValues values = WalkValues::Colours)
        : m_form(form)
        , m_coverage(coverage)
        , m_values(values)
        , m_names(form)
    {
    }

    void add(int depth, const QString &text, const std::vector<Moment> &moments,
             LineOf of = LineOf::EveryPrimitive);
    /// Adds a line that a variant changes.
    void addVaried(int depth, const QString &text, const std::vector<Moment> &moments,
                   const std::vector<VariedLine> &varied, LineOf of = LineOf::EveryPrimitive);

    void addSorting();
    /// What each span adds along the edges.
    void addSlopes();
    /// m of each edge. The divisor may be changed, and what it must exceed.
    QString slope(const QString &change, const QString &less) const;
    void addRejection();
    /// The loop over the spans, with the two bounds in each.
    void addSpans(int depth = 0);
    /// Tells the two bounds apart.
    void addOrder(int depth);
    /// The loop over a span's samples.
    void addSamples(int depth = 1);
    /// "y₀₂ ← y₀ + (x − x₀)·m₀₂", and of what is carried likewise: a bound from a vertex of its
    /// edge.
    QString longBoundFromVertex() const { return fromVertex("₀₂", "₀", way("₀")); }
    QString shortBoundFromVertex() const { return fromVertex("_ij", "_i", way("_i")); }
    /// Which of the two is the lower one.
    QString orderedByArea() const;

    /// The lines, in the letters of the form.
    Pseudocode written();
    /// The lines so far with the letters l, m and r for P₀, P₁ and P₂.
    void nameSortedVerticesByLetters();

    const std::vector<Moment> everySpan = {Moment::Begin, Moment::TakeOver, Moment::Span};

private:
    bool isRow() const { return m_form.axis == SpanAxis::Row; }
    bool isDirect() const { return m_form.walk == WalkForm::Direct; }
    bool isExact() const { return m_coverage == WalkCoverage::Exact; }
    /// Whether colours are walked along the edges.
    bool carriesColours() const
    {
        return m_form.rate == ColourRate::Bilinear
            || !(isDirect() || isExact() || m_values == WalkValues::Carried);
    }
    QString alike() const;
    QString areaRemark() const;
    QString areaName() const { return m_values == WalkValues::Carried ? u"S"_s : u"A"_s; }

    template <class Text>
    void addRules(const Text &text);
    QString spans(FillRule rule, FrameOrigin origin) const;
    QString samples(FillRule rule, FrameOrigin origin) const;
    QString way(const QString &vertex) const;
    QString fromVertex(const QString &edge, const QString &vertex, const QString &way) const;
    QString added(const QString &edge) const;
    void addBounds(int depth);
    void addBeginning(int depth, const QString &where, const QString &edge, const QString &vertex,
                      const std::vector<Moment> &moments, LineOf of);
    QString ordered(const QString &condition) const;
    QString orderedWithSlopes() const;

    EdgeWalkForm m_form;
    WalkCoverage m_coverage;
    WalkValues m_values;
    EdgeWalkNames m_names;
    Pseudocode m_code;
};

/// The whole listing of a walk that carries colours along its edges.
Pseudocode walkPseudocode(const EdgeWalkForm &form, WalkCoverage coverage);
/// With effects beyond colour: the column scan's, which is the bilinear interpolation's between
/// bounds as computed.
Pseudocode shadedColumnScanPseudocode();

} // namespace pixelplumb
