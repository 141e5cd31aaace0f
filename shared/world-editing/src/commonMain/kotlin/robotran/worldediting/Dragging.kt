package robotran.worldediting

import robotran.editing.Gesture
import robotran.editing.dropped
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

internal fun WorldEditing.grabbed(edit: WorldEdit.StartDrag): WorldEditing {
    val begun = dropped()
    return if (begun.selection.isEmpty()) begun else begun.copy(gesture = Gesture(edit.grip, edit.at, begun.snapshot))
}

/** Moves the dragged elements with the pointer; where they cannot go, they keep their last position. */
internal fun WorldEditing.dragged(edit: WorldEdit.DragTo): WorldEditing {
    val held = gesture ?: return this
    val drag = Drag(held, snapping, edit)
    val (pieces, guides) = when (val grip = held.handle) {
        DragHandle.Body -> drag.moved()
        DragHandle.Turn -> drag.turned()
        is DragHandle.Size -> drag.resized(grip.side)
        is DragHandle.Corner -> drag.corner(grip.number)
        is DragHandle.Edge -> drag.edge(grip.number)
    } ?: return this
    if (pieces.values.any { errorOf(it) != null }) return this
    val moved = pieces.entries.fold(held.before.world) { world, (thing, piece) -> world.with(thing.number, piece) }
    if (errorOf(moved) != null) return this
    return copy(world = moved, guides = guides, errors = quickValidationErrorsOf(moved))
}

/** Computes a drag from the state at its start. */
private class Drag(
    private val held: Gesture<WorldSnapshot, DragHandle>,
    private val snapping: Snapping,
    private val edit: WorldEdit.DragTo,
) {
    private val world = held.before.world
    private val things = held.before.selection
    private val pieces = things.mapNotNull { thing -> world.piece(thing)?.let { thing to it } }.toMap()
    private val frame = world.frameOf(things)

    fun moved(): Pair<Map<ElementRef, Element>, List<Guide>>? {
        val bounds = around(pieces.values.mapNotNull { it.form?.bounds }) ?: return null
        val anchor = pieces.values.firstNotNullOf { it.form?.anchor }
        val lines = world.snapLines(things)
        val x = snapping.move(
            edit.at.x - held.from.x,
            listOf(bounds.left, bounds.middle.x, bounds.right),
            anchor.x,
            lines.across,
            edit.reach,
        )
        val y = snapping.move(
            edit.at.y - held.from.y,
            listOf(bounds.bottom, bounds.middle.y, bounds.top),
            anchor.y,
            lines.up,
            edit.reach,
        )
        return changed { it.movedBy(x.coordinate, y.coordinate) } to guides(x, y)
    }

    fun turned(): Pair<Map<ElementRef, Element>, List<Guide>>? {
        val only = pieces.values.singleOrNull()?.form
        val middle = only?.middle ?: frame?.centre ?: return null
        val from = headingTo(middle, held.from) ?: return null
        val to = headingTo(middle, edit.at) ?: return null
        val before = only?.heading ?: 0.0
        val degrees = snapping.onAngle(before + to - from) - before
        return changed { it.rotatedBy(degrees, middle) } to emptyList()
    }

    fun resized(side: SizeSide): Pair<Map<ElementRef, Element>, List<Guide>>? {
        val box = frame ?: return null
        val corner = box.at(side.across, side.up)
        val wanted = Point(corner.x + edit.at.x - held.from.x, corner.y + edit.at.y - held.from.y)
        val only = (pieces.values.singleOrNull()?.form as? Form.Area)?.shape
        val (to, guides) = if (box.angle == 0.0) {
            snapping.point(wanted, world.snapLines(things), edit.reach)
        } else {
            snapping.onGrid(wanted) to emptyList()
        }
        if (only != null && only !is Shape.Polygon) return changed { Form.Area(only.resized(side, to)) } to guides
        return changed { it.scaledBy(factorFor(box, side, to), box.at(-side.across, -side.up)) } to guides
    }

    fun corner(number: Int): Pair<Map<ElementRef, Element>, List<Guide>>? = single { form ->
        val corners = form.corners
        if (number !in corners.indices) return@single null
        val (to, guides) = snapped(corners[number], form.neighboursOf(number))
        form.withCorners(corners.with(number, to)) to guides
    }

    fun edge(number: Int): Pair<Map<ElementRef, Element>, List<Guide>>? = single { form ->
        val (from, to) = form.edges().getOrNull(number) ?: return@single null
        val (place, guides) = snapped(middleOf(from, to), listOf(from, to))
        form.withCorners(form.corners.take(number + 1) + place + form.corners.drop(number + 1)) to guides
    }

    private fun snapped(corner: Point, neighbours: List<Point>): Pair<Point, List<Guide>> {
        val wanted = Point(corner.x + edit.at.x - held.from.x, corner.y + edit.at.y - held.from.y)
        return snapping.point(wanted, world.cornerLines(things, neighbours), edit.reach)
    }

    private fun single(change: (Form) -> Pair<Form, List<Guide>>?): Pair<Map<ElementRef, Element>, List<Guide>>? {
        val (thing, piece) = pieces.entries.singleOrNull() ?: return null
        val (form, guides) = piece.form?.let(change) ?: return null
        return mapOf(thing to piece.withForm(form)) to guides
    }

    private fun changed(change: (Form) -> Form): Map<ElementRef, Element> =
        pieces.mapValues { (_, piece) -> piece.form?.let { piece.withForm(change(it)) } ?: piece }
}

/** The point that snaps to the grid. */
private val Form.anchor: Point
    get() = when (this) {
        is Form.Area -> when (shape) {
            is Shape.Rectangle -> if (shape.angle == 0.0) Point(bounds.left, bounds.bottom) else shape.centre
            is Shape.Circle -> shape.centre
            is Shape.Polygon -> shape.corners.first()
        }

        is Form.Way -> points.first()
        is Form.Start, is Form.Light -> middle
        is Form.Picture -> corner
    }

/** The heading, if there is one; a line faces from its first to its last point. */
private val Form.heading: Double
    get() = when (this) {
        is Form.Area -> (shape as? Shape.Rectangle)?.angle ?: 0.0
        is Form.Way -> headingTo(points.first(), points.last()) ?: 0.0
        is Form.Start -> pose.heading
        is Form.Light -> direction
        is Form.Picture -> 0.0
    }

private fun Form.neighboursOf(number: Int): List<Point> {
    val all = corners
    val before = if (number > 0) all[number - 1] else all.last().takeIf { isRound }
    val after = if (number < all.lastIndex) all[number + 1] else all.first().takeIf { isRound }
    return listOfNotNull(before, after)
}
