// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/tests/edgeteststate.h"
#include "tests/support/listings/listinglanguage.h"

#include <QRgb>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace pixelplumb {

/// What a running listing has computed and drawn. Its statements are
///   A, B ← C, D        add A, B to C, D        A ← B; C and D likewise
///   E₀: A, B ← C, D; E₁ and E₂ likewise       of an edge: E₀ only names it
///   A ← 1 if B > 0, else −1        A, B ← C, D if E > 0, else D, C
///   L_ij ← L₀₁ if x < x₁, else L₁₂            the edge whose digits i and j are from here on
///   sort the vertices by x, those of equal x by y: P₀, P₁, P₂
///                                             or "by y, the largest first, those of equal y by x"
///   exchange x and y, here and where a pixel is written
///   exchange the ends                         A₀ and A₁ for every A
///   done                                      nothing more is run
///   exchange i and j                          the digits of the edge
///   A[B] ← C                                  a value for each B
///   pixel (A, B) ← the bytes of R, G, B       writes nothing outside the frame
///   pixel (A, B) ← colour                     the shape's: "colour R", "colour G", "colour B"
///   pixel (A ± B, C) ← colour                 both pixels
///   frame[A] ← colour
///   pixel (A, B) ← the mean of its samples    R[k, A, B] and so on for k = 1 … n
///   A, B, C ← the bytes of R, G, B            A, B, C ← pixel (x, y), its bytes
///   A, B ← name(C, D)                         a function that the listing's head says is given
///   carry A, B                                from here on values that the triangle carries
///   for each carried value v but A and B: …   statements with each one's name for v
///   on to the next row                        the rest of the loop's round is left out
///   given: …                                  told to the reader
/// with the expressions of listinglanguage.h.
class ListingState {
public:
    using Number = BigRational;
    using Pixels = std::map<std::pair<std::int64_t, std::int64_t>, QRgb>; ///< by (x, y)
    /// For a steep line, x and y are swapped when a pixel is written.
    enum class Exchange { None, Axes };

    ListingState(ListingNames names, const SampleBox &box)
        : m_names(std::move(names))
        , m_exact(m_names)
        , m_box(box)
    {
    }
    /// Which values are kept, and which of them decisions and loops read.
    enum class Asked { AsComputed, Exact };
    /// From here on each operation rounds its result to this arithmetic: exact, float32 or float64.
    /// Exact values are kept beside the rounded ones where lines ask for them.
    void computeIn(Arithmetic arithmetic, Asked kept)
    {
        m_arithmetic = arithmetic;
        m_keepsExact = arithmetic != Arithmetic::Exact && kept == Asked::Exact;
    }
    void ask(Asked asked) { m_asked = asked; }

    /// Throws ListingFault, as all of these do.
    void run(const QString &statements);
    bool holds(const QString &condition) const;
    /// Of an expression, or of the side of "A if B > 0, else C" that holds.
    Number valueOf(const QString &expression) const;

    bool knows(const QString &name) const { return m_names.contains(name); }
    void set(const QString &name, const Number &value) { set(name, Result{value, value}); }
    /// What a listing calls, by name: takes and returns numbers.
    using Given
        = std::map<QString, std::function<std::vector<Number>(const std::vector<Number> &)>>;
    void setGiven(Given given) { m_given = std::move(given); }
    /// What the pixels hold that the listing has not drawn.
    void setUnder(Pixels pixels) { m_under = std::move(pixels); }
    const ListingNames &names() const { return m_names; }
    /// Forgets the names that are not among these; none if there are none.
    void keepOnly(const ListingNames &known)
    {
        for (ListingNames *names : {&m_names, &m_exact})
            std::erase_if(*names, [&](const auto &name) {
                return !known.empty() && !known.contains(name.first);
            });
    }
    /// Whether the rest of a loop's round is left out; asking ends that.
    bool takesLeave() { return std::exchange(m_leaves, false); }
    bool leaves() const { return m_leaves; }
    /// The last pixel that was written; asking forgets it.
    std::optional<std::pair<std::int64_t, std::int64_t>> takeWritten()
    {
        return std::exchange(m_written, {});
    }
    void setExchange(Exchange exchange) { m_exchange = exchange; }
    /// The samples of the frame along a coordinate that a loop goes through: first and last.
    std::pair<std::int64_t, std::int64_t> frameAlong(const QString &coordinate) const;

    /// Lets i and j stand for the two digits of an edge, k for a number; nothing if empty.
    void setEdge(const QString &digits) { m_edge = digits; }
    void setIndex(const QString &index) { m_index = index; }
    /// Those for which A[…] has a value, ascending.
    std::vector<Number> indicesOf(const QString &name) const;
    /// The text with what i, j, k and indices stand for.
    QString meant(QString text) const;

    const Pixels &pixels() const { return m_pixels; }

private:
    struct Result {
        Number computed, exact;
    };
    Result resultOf(const QString &expression) const;
    void set(const QString &name, const Result &result);
    void runStatement(const QString &statement);
    QString chosen(const QString &expression) const;
    void assign(const QString &statement);
    void add(const QString &statement);
    static void sortVertices(const QString &statement, ListingNames &names);
    void exchangeAxes();
    void exchangeEnds();
    void draw(const QString &statement);
    void write(const QString &place, QRgb colour);
    Number byteOf(const QString &level) const;
    std::vector<Result> resultsOf(const QString &right) const;
    bool isCall(const QString &right) const;
    QRgb pixelAt(const QString &place) const;
    QRgb meanAt(const QString &place) const;

    ListingNames m_names; ///< as computed
    ListingNames m_exact; ///< without rounding
    Arithmetic m_arithmetic = Arithmetic::Exact;
    bool m_keepsExact = false;
    Asked m_asked = Asked::AsComputed;
    SampleBox m_box;
    Exchange m_exchange = Exchange::None;
    QString m_edge, m_index;
    std::map<QString, QStringList> m_spelledOut; ///< the statements of the texts that were run
    Pixels m_pixels, m_under;
    Given m_given;
    QStringList m_carried;
    bool m_leaves = false;
    std::optional<std::pair<std::int64_t, std::int64_t>> m_written;
};

} // namespace pixelplumb
