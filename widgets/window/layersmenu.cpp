// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/layersmenu.h"

#include "core/layers/layer.h"
#include "widgets/canvas/imageedit.h"
#include "widgets/look/corewords.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/scenedocument.h"

namespace pixelplumb {

LayersMenu::LayersMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Layers"), window)
{
    setObjectName(QStringLiteral("layersMenu"));
    setToolTipsVisible(true);
    for (const Layer &layer : layers())
        addLayer(layer, parts);
    addSeparator();
    DisplayOptions *options = parts.options;
    QAction *none
        = addMenuAction(this, "hideLayers", tr("&Hide all layers"),
                        Qt::CTRL | Qt::SHIFT | Qt::Key_L, [options] { options->setLayers({}); });
    const auto update = [options, none] { none->setEnabled(!options->layers().isEmpty()); };
    connect(options, &DisplayOptions::changed, none, update);
    update();
    QAction *firstMap
        = addMenuAction(this, "firstAffineMap", tr("&First affine map again"), {},
                        [options, document = parts.document] {
                            document->undoStack()->push(new ImageEdit(*options, std::nullopt));
                        });
    const auto follow
        = [options, firstMap] { firstMap->setEnabled(options->affineImage().has_value()); };
    connect(options, &DisplayOptions::changed, firstMap, follow);
    connect(parts.document, &SceneDocument::opened, firstMap, &QAction::trigger);
    follow();
}

void LayersMenu::addLayer(const Layer &layer, const WindowParts &parts)
{
    DisplayOptions *options = parts.options;
    const SceneDocument *document = parts.document;
    QAction *action = addMenuAction(this, "", coreWord(layer.title), {},
                                    [options, &layer] { options->toggleLayer(layer.id); });
    action->setObjectName(QStringLiteral("layer-") + layer.id);
    action->setCheckable(true);
    const auto check
        = [options, action, &layer] { action->setChecked(options->layers().contains(layer.id)); };
    const auto tell = [document, action, &layer] {
        const QString objection = layer.objection(document->scene());
        const QString text
            = objection.isEmpty() ? layer.toolTip : tr("Nothing to show: %1.").arg(objection);
        action->setEnabled(objection.isEmpty());
        action->setStatusTip(text);
        // Rich text wraps.
        action->setToolTip(QStringLiteral("<p>%1</p><p>%2</p>")
                               .arg(text.toHtmlEscaped(), layer.source.toHtmlEscaped()));
    };
    connect(options, &DisplayOptions::changed, action, check);
    connect(document, &SceneDocument::sceneChanged, action, tell);
    check();
    tell();
}

} // namespace pixelplumb
