package robotran.ui.worldedit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.rotate
import androidx.compose.ui.unit.dp
import robotran.ui.editing.EditingColours
import robotran.ui.editing.HandleAt
import robotran.ui.editing.drawChosenFrame
import robotran.ui.editing.drawKnob
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.addLine
import robotran.uikit.*
import robotran.world.geometry.Point
import robotran.worldediting.DragHandle
import robotran.worldediting.SelectionFrame
import robotran.worldediting.WorldEditing
import robotran.worldediting.bounds
import robotran.worldediting.form
import robotran.worldediting.frameOf
import robotran.worldediting.piece

/** The overlay of the world editor: frames around the selection, handles, guides and signs at errors. */
internal fun DrawScope.drawEditing(
    editing: WorldEditing,
    transform: SheetTransform,
    view: EditView,
    colours: RobotranColours,
) {
    drawErrors(editing, transform, colours)
    for (guide in editing.guides) drawGuide(guide.isUpright, guide.at, transform)
    if (editing.selection.size > 1) {
        for (thing in editing.selection) editing.world.frameOf(setOf(thing))?.let { drawFrame(it, transform, THIN) }
    }
    editing.world.frameOf(editing.selection)?.let { drawFrame(it, transform, THICK) }
    if (editing.gesture == null) drawHandles(positionedHandles(editing, transform, density))
    view.box?.let { box ->
        drawRect(EditingColours.ACCENT.copy(alpha = 0.12f), box.topLeft, box.size)
        drawRect(EditingColours.ACCENT, box.topLeft, box.size, style = Stroke(1.5.dp.toPx(), pathEffect = dashes()))
    }
    if (view.line.size > 1) {
        val path = Path().apply { addLine(view.line) }
        drawPath(
            path,
            EditingColours.ACCENT,
            style = Stroke(3.dp.toPx(), cap = StrokeCap.Round, join = StrokeJoin.Round),
        )
    }
}

private fun DrawScope.drawFrame(frame: SelectionFrame, transform: SheetTransform, width: Float) {
    val corners = listOf(-1 to -1, 1 to -1, 1 to 1, -1 to 1).map { (across, up) ->
        transform.toPixels(frame.at(across, up))
    }
    drawChosenFrame(corners, width.dp, (width + 2).dp)
}

private fun DrawScope.drawHandles(handles: List<HandleAt<DragHandle>>) {
    for ((handle, at) in handles.map { it.handle to it.at }) {
        if (handle is DragHandle.Edge) drawPlus(at) else drawKnob(at, isRound = handle !is DragHandle.Size, KNOB)
    }
    handles.firstOrNull { it.handle == DragHandle.Turn }?.let { drawTurnArrow(it.at) }
}

private fun DrawScope.drawPlus(position: Offset) {
    val radius = 7.dp.toPx()
    drawCircle(EditingColours.ACCENT, radius, position)
    val arm = radius * 0.55f
    drawLine(RobotranColours.CASING, position - Offset(arm, 0f), position + Offset(arm, 0f), 2.dp.toPx())
    drawLine(RobotranColours.CASING, position - Offset(0f, arm), position + Offset(0f, arm), 2.dp.toPx())
}

private fun DrawScope.drawTurnArrow(position: Offset) {
    val radius = 13.dp.toPx()
    drawCircle(RobotranColours.CASING, radius, position)
    drawCircle(EditingColours.ACCENT, radius, position, style = Stroke(2.dp.toPx()))
    val arc = radius * 0.55f
    drawArc(
        EditingColours.ACCENT,
        -60f,
        280f,
        false,
        position - Offset(arc, arc),
        Size(arc * 2, arc * 2),
        style = Stroke(2.dp.toPx(), cap = StrokeCap.Round),
    )
    rotate(220f, position) {
        val tip = position + Offset(arc, 0f)
        val head = 4.dp.toPx()
        drawLine(EditingColours.ACCENT, tip, tip + Offset(-head, -head), 2.dp.toPx(), StrokeCap.Round)
        drawLine(EditingColours.ACCENT, tip, tip + Offset(head, -head), 2.dp.toPx(), StrokeCap.Round)
    }
}

private fun DrawScope.drawGuide(isUpright: Boolean, at: Double, transform: SheetTransform) {
    val place = transform.toPixels(Point(at, at))
    val from = if (isUpright) Offset(place.x, 0f) else Offset(0f, place.y)
    val to = if (isUpright) Offset(place.x, size.height) else Offset(size.width, place.y)
    drawLine(EditingColours.GUIDE, from, to, 1.5.dp.toPx(), pathEffect = dashes())
}

/** A triangle with an exclamation mark above the element. */
private fun DrawScope.drawErrors(editing: WorldEditing, transform: SheetTransform, colours: RobotranColours) {
    for (thing in editing.errors.mapNotNull { it.thing }.distinct()) {
        val bounds = editing.world.piece(thing)?.form?.bounds ?: continue
        val place = transform.toPixels((bounds.left + bounds.right) / 2, bounds.top) - Offset(0f, 14.dp.toPx())
        val margin = 16.dp.toPx()
        val inside = Offset(
            place.x.coerceIn(margin, maxOf(margin, size.width - margin)),
            place.y.coerceIn(margin, maxOf(margin, size.height - margin)),
        )
        drawCircle(colours.errorPane, 15.dp.toPx(), inside)
        drawCircle(colours.error, 15.dp.toPx(), inside, style = Stroke(2.dp.toPx()))
        val unit = 20.dp.toPx() / Icon.UNITS
        drawContext.canvas.save()
        drawContext.transform.translate(inside.x - 10.dp.toPx(), inside.y - 11.dp.toPx())
        drawContext.transform.scale(unit, unit, Offset.Zero)
        drawPath(WARNING_TRIANGLE, colours.error, style = Stroke(2f, join = StrokeJoin.Round))
        drawLine(colours.error, Offset(12f, 10f), Offset(12f, 14f), 2f, StrokeCap.Round)
        drawLine(colours.error, Offset(12f, 17f), Offset(12f, 17.1f), 2.4f, StrokeCap.Round)
        drawContext.canvas.restore()
    }
}

private fun DrawScope.dashes() = PathEffect.dashPathEffect(floatArrayOf(6.dp.toPx(), 4.dp.toPx()))

private const val THICK = 2f
private const val THIN = 1f
private val KNOB = 7.dp
private val WARNING_TRIANGLE = Path().apply {
    moveTo(12f, 4f)
    lineTo(21f, 20f)
    lineTo(3f, 20f)
    close()
}
