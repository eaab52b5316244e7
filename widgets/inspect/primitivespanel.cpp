// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/primitivespanel.h"

#include "widgets/inspect/delegates.h"
#include "widgets/inspect/primitivestree.h"
#include "widgets/look/colourbutton.h"
#include "widgets/look/parts.h"
#include "widgets/model/primitivelistmodel.h"

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int cellMargin = 4;
constexpr int widthForPlaces = 360; ///< of the panel
constexpr int nameWidth = 110; ///< that long numbers leave for names

} // namespace

PrimitivesPanel::PrimitivesPanel(SceneDocument *document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_model(new PrimitiveListModel(document, this))
    , m_tree(new PrimitivesTree(this))
    , m_summary(new QLabel(this))
{
    setObjectName(u"primitives"_s);
    named(m_tree, "primitivesTree", tr("Primitives in drawing order"));
    m_tree->setModel(m_model);
    m_tree->setItemDelegate(new VertexDelegate(document, m_tree));
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(false);
    fitColumns();
    m_summary->setObjectName(u"primitivesSummary"_s);
    m_summary->setWordWrap(true);

    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    addActions(row);
    row->addStretch();
    withParts(new QVBoxLayout(this), {m_tree, row, m_summary}, 4, 8);
    setFocusProxy(m_tree);

    onEvents(this, {QEvent::Resize}, [this] {
        m_tree->setColumnHidden(PrimitiveListModel::Place, width() < widthForPlaces);
        fitColumns();
    });
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_tree, &QWidget::customContextMenuRequested, this, [this](const QPoint &position) {
        if (m_tree->indexAt(position).isValid())
            m_menu->popup(m_tree->viewport()->mapToGlobal(position));
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &PrimitivesPanel::chooseRow);
    connect(document, &SceneDocument::selectionChanged, this, &PrimitivesPanel::followSelection);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
        const QModelIndex index = m_tree->currentIndex();
        m_lastRow = index.parent().isValid() ? index.parent().row() : index.row();
    });
    connect(m_model, &QAbstractItemModel::modelReset, this, &PrimitivesPanel::followReset);
    // A tree repaints the changed rows of one level, not the rows below them.
    connect(m_model, &QAbstractItemModel::dataChanged, m_tree->viewport(),
            qOverload<>(&QWidget::update));
    connect(m_tree, &PrimitivesTree::colourAsked, this, &PrimitivesPanel::chooseColour);
    connect(document, &SceneDocument::sceneChanged, this, &PrimitivesPanel::update);
    connect(m_tree, &QTreeView::expanded, this, &PrimitivesPanel::fitColumns);
    followSelection();
}

/// A name gets the width that numbers and a colour leave. The visible numbers are shown to the last
/// digit while there is room for the names.
void PrimitivesPanel::fitColumns()
{
    QHeaderView *header = m_tree->header();
    const auto fit = [&](int column, const QString &widest, int beside) {
        const int text = m_tree->fontMetrics().horizontalAdvance(widest) + beside + 2 * cellMargin;
        header->resizeSection(column, std::max(text, header->sectionSizeHint(column)));
    };
    fit(PrimitiveListModel::Place, u"00"_s, 0);
    fit(PrimitiveListModel::ColourText, u"#dddddd"_s,
        style()->pixelMetric(QStyle::PM_SmallIconSize) + cellMargin);
    const int room = m_tree->viewport()->width() - nameWidth
        - header->sectionSize(PrimitiveListModel::Place) // hidden: 0
        - header->sectionSize(PrimitiveListModel::ColourText);
    for (const int column : {PrimitiveListModel::X, PrimitiveListModel::Y}) {
        fit(column, u"000.0"_s, 0);
        const int least = header->sectionSize(column);
        const int asked = static_cast<QAbstractItemView *>(m_tree)->sizeHintForColumn(column);
        header->resizeSection(column, std::clamp(asked, least, std::max(least, room / 2)));
    }
    header->setStretchLastSection(false);
    header->setSectionResizeMode(PrimitiveListModel::Name, QHeaderView::Stretch);
}

/// Adds each action as a button below the list and as an entry of the row menu.
void PrimitivesPanel::addActions(QHBoxLayout *row)
{
    m_menu = named(new QMenu(m_tree), "primitivesMenu");
    m_menu->setToolTipsVisible(true);
    const auto add = [this, row](const char *name, const QString &text, const QString &tip) {
        QAction *action = m_menu->addAction(text);
        action->setObjectName(QLatin1String(name));
        action->setToolTip(tip);
        auto *button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setObjectName(action->objectName());
        button->setAccessibleName(text);
        connect(action, &QAction::changed, button,
                [action, button] { button->setAccessibleName(action->text()); });
        button->setFocusPolicy(Qt::TabFocus); // the current row keeps the focus
        row->addWidget(button);
        return action;
    };
    m_up = add("primitivesUp", tr("Earlier"), tr("Draw it before the one above"));
    m_down = add("primitivesDown", tr("Later"), tr("Draw it after the one below"));
    m_colour = add("primitivesColour", tr("Colour…"),
                   tr("The colour of the vertex, or of all vertices of the primitive"));
    m_form = add("primitivesForm", tr("Form"),
                 tr("The forms it can take, such as circle or ellipse, outlined or filled"));
    m_forms = new PrimitiveForms(m_document, this);
    m_form->setMenu(m_forms);
    findChild<QToolButton *>(m_form->objectName())->setPopupMode(QToolButton::InstantPopup);
    m_hide = add("primitivesHide", {}, {}); // set for the current row
    m_remove = add("primitivesDelete", tr("Delete"), tr("Delete the primitive"));
    m_remove->setShortcutContext(Qt::WidgetShortcut); // a field in the list has the key itself
    m_tree->addAction(m_remove);
    connect(m_up, &QAction::triggered, this, [this] { moveBy(-1); });
    connect(m_down, &QAction::triggered, this, [this] { moveBy(1); });
    connect(m_colour, &QAction::triggered, this, &PrimitivesPanel::chooseColour);
    connect(m_hide, &QAction::triggered, this, &PrimitivesPanel::hideOrShow);
    connect(m_remove, &QAction::triggered, this, &PrimitivesPanel::remove);
}

void PrimitivesPanel::takeKeysOf(const QAction *deletion)
{
    const auto take = [this, deletion] { m_remove->setShortcuts(deletion->shortcuts()); };
    connect(deletion, &QAction::changed, this, take);
    take();
}

void PrimitivesPanel::hideOrShow()
{
    const QModelIndex index = m_tree->currentIndex();
    const QModelIndex whole = m_model->isPrimitive(index) ? index : index.parent();
    const QModelIndex name = whole.siblingAtColumn(PrimitiveListModel::Name);
    const bool isShown = name.data(Qt::CheckStateRole) == Qt::Checked;
    m_model->setData(name, isShown ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

std::optional<VertexRef> PrimitivesPanel::currentRef() const
{
    const QModelIndex index = m_tree->currentIndex();
    return index.isValid() ? m_model->refAt(index) : std::nullopt;
}

void PrimitivesPanel::chooseRow(const QModelIndex &index)
{
    if (!m_following && index.isValid()) {
        const QScopedValueRollback following(m_following, true);
        m_document->selectVertex(m_model->refAt(index));
    }
    update();
}

/// The current row stays, even if its primitive was hidden or shown.
void PrimitivesPanel::followReset()
{
    followSelection();
    if (!m_tree->currentIndex().isValid() && m_lastRow >= 0)
        m_tree->setCurrentIndex(
            m_model->index(std::min(m_lastRow, m_model->rowCount() - 1), PrimitiveListModel::Name));
}

void PrimitivesPanel::remove()
{
    if (const std::optional<VertexRef> ref = currentRef())
        m_document->deletePrimitive(ref->primitive);
    else if (const std::optional<int> hidden = m_model->hiddenAt(m_tree->currentIndex()))
        m_document->deleteHidden(*hidden);
    else if (const auto solid = m_model->solidAt(m_tree->currentIndex()))
        m_document->deleteSolid(*solid);
}

/// A row is current only if the document has selected it, or if it is hidden; otherwise the
/// window's keys would not act on it as documented.
void PrimitivesPanel::followSelection()
{
    std::optional<VertexRef> ref = m_document->selectedVertex();
    if (ref && ref->primitive == VertexRef::pending)
        ref.reset(); // it has no row
    if (!m_following && currentRef() != ref) {
        const QScopedValueRollback following(m_following, true);
        m_tree->setCurrentIndex(ref ? m_model->indexOf(*ref) : QModelIndex());
    }
    update();
}

void PrimitivesPanel::update()
{
    fitColumns();
    const int count = m_document->primitiveCount();
    const std::size_t solids = m_document->scene().solids.size();
    QString text = tr("%n primitives", nullptr, count);
    if (const int hidden = m_document->hiddenCount(); hidden > 0)
        text += tr(", and %n hidden that the numbers leave out", nullptr, hidden);
    if (solids > 0)
        text += tr(" and %n solids", nullptr, int(solids))
            + tr(". The camera makes the triangles of a solid; the Projection panel shows both");
    m_summary->setText(text);
    const std::optional<VertexRef> ref = currentRef();
    const bool isHidden = m_model->hiddenAt(m_tree->currentIndex()).has_value();
    const std::optional<std::size_t> solid = m_model->solidAt(m_tree->currentIndex());
    const auto canMove = [&](int places) {
        return ref ? m_document->canMovePrimitive(ref->primitive, places)
                   : solid && m_document->canMoveSolid(*solid, places);
    };
    m_up->setEnabled(canMove(-1));
    m_down->setEnabled(canMove(1));
    m_colour->setEnabled(ref || solid);
    m_forms->offer(ref ? std::optional(ref->primitive) : std::nullopt);
    m_form->setEnabled(m_forms->isEnabled());
    const bool showsAgain = isHidden || (solid && m_document->scene().solids[*solid].isHidden);
    m_hide->setEnabled(ref || isHidden || solid);
    m_remove->setEnabled(ref || isHidden || solid);
    m_hide->setText(showsAgain ? tr("Show") : tr("Hide"));
    m_hide->setToolTip(
        showsAgain
            ? tr("Draw the primitive again, at its place; the others are numbered with it")
            : tr("Keep the primitive and do not draw it; the others are numbered without it. "
                 "The box before its name shows it again"));
}

void PrimitivesPanel::moveBy(int places)
{
    const std::optional<VertexRef> ref = currentRef();
    if (const auto solid = m_model->solidAt(m_tree->currentIndex())) {
        const int row = m_tree->currentIndex().row();
        m_document->moveSolid(*solid, places);
        return m_tree->setCurrentIndex(m_model->index(row + places, PrimitiveListModel::Name));
    }
    if (!ref || !m_document->canMovePrimitive(ref->primitive, places))
        return;
    const bool isWhole = m_model->isPrimitive(m_tree->currentIndex());
    m_document->movePrimitive(ref->primitive, places);
    const VertexRef moved{ref->primitive + places, ref->vertex};
    m_tree->setCurrentIndex(isWhole ? m_model->indexOfPrimitive(moved.primitive)
                                    : m_model->indexOf(moved));
}

void PrimitivesPanel::chooseColour()
{
    if (const auto solid = m_model->solidAt(m_tree->currentIndex()))
        return chooseSolidColour(*solid);
    const std::optional<VertexRef> ref = currentRef();
    if (!ref)
        return;
    const bool isWhole = m_model->isPrimitive(m_tree->currentIndex());
    const std::optional<Colour> colour
        = askForColour(m_document->vertexAt(*ref)->colour,
                       isWhole ? tr("Colour of the Primitive") : tr("Colour of the Vertex"), this);
    if (!colour)
        return;
    if (isWhole)
        m_document->setPrimitiveColour(ref->primitive, *colour);
    else
        m_document->setVertexColour(*ref, *colour);
}

void PrimitivesPanel::chooseSolidColour(std::size_t index)
{
    Solid solid = m_document->scene().solids[index];
    const bool isOfCorners
        = solid.kind == SolidKind::Triangle3 || solid.kind == SolidKind::Polygon3;
    const std::optional<Colour> colour = askForColour(
        isOfCorners ? solid.corners.front().colour : solid.colour, tr("Colour of the Solid"), this);
    if (!colour)
        return;
    if (isOfCorners) {
        for (SolidCorner &corner : solid.corners)
            corner.colour = *colour;
    } else {
        solid.colour = *colour;
    }
    m_document->setSolid(index, solid, m_document->newDrag());
}

} // namespace pixelplumb
