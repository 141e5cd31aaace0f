package robotran.worldediting

import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.robot.box

/** The part of an element that the user drags. */
sealed interface DragHandle {
    /** The element itself, to move it. */
    data object Body : DragHandle

    data class Size(val side: SizeSide) : DragHandle

    data object Turn : DragHandle

    /** A corner of a polygon or a point of a line. */
    data class Corner(val number: Int) : DragHandle

    /** The midpoint between a corner and the next; dragging it adds a corner. */
    data class Edge(val number: Int) : DragHandle
}

/** The position of a resize handle: left or right of the centre ([across] -1 or 1), below or above it ([up]). */
enum class SizeSide(val across: Int, val up: Int) {
    RIGHT(1, 0),
    TOP_RIGHT(1, 1),
    TOP(0, 1),
    TOP_LEFT(-1, 1),
    LEFT(-1, 0),
    BOTTOM_LEFT(-1, -1),
    BOTTOM(0, -1),
    BOTTOM_RIGHT(1, -1),
    ;

    val isCorner: Boolean get() = across != 0 && up != 0
}

/**
 * A drag handle of an element.
 *
 * @property place its point of the element.
 * @property outwards the direction in which the handle may be offset so that it does not cover the element; of length
 * 1, or 0 for none.
 */
data class Handle(val grip: DragHandle, val place: Point, val outwards: Point)

/** The rectangle, rotated by [angle], that carries the handles. */
data class SelectionFrame(val centre: Point, val width: Double, val height: Double, val angle: Double) {
    private val direction = Direction(angle)

    /** The point at these multiples of half the width and height from the centre. */
    fun at(across: Int, up: Int): Point = direction.from(centre, across * width / 2, up * height / 2)

    /** [point] relative to the centre, along the width and the height. */
    internal fun seen(point: Point): Point = relativeTo(centre, direction, point)

    internal fun outwards(across: Int, up: Int): Point {
        val part = if (across != 0 && up != 0) DIAGONAL else 1.0
        return direction.from(Point(0.0, 0.0), across * part, up * part)
    }

    private companion object {
        const val DIAGONAL = 0.7071
    }
}

/** The frame around all of [things]; null if none of them has a position. */
fun World.frameOf(things: Set<ElementRef>): SelectionFrame? {
    val forms = things.mapNotNull { piece(it)?.form }
    val shape = (forms.singleOrNull() as? Form.Area)?.shape
    if (shape is Shape.Rectangle) return SelectionFrame(shape.centre, shape.width, shape.height, shape.angle)
    return around(forms.map { it.bounds })?.let { SelectionFrame(it.middle, it.width, it.height, 0.0) }
}

/** All handles of [things] together. */
fun World.handlesOf(things: Set<ElementRef>): List<Handle> {
    val forms = things.mapNotNull { piece(it)?.form }
    val frame = frameOf(things) ?: return emptyList()
    val form = forms.singleOrNull() ?: return handlesOfSeveral(forms, frame)
    return when {
        form.corners.isNotEmpty() -> cornerHandles(form, frame) + turnHandle(frame)

        form is Form.Area -> sizeHandles(frame, SizeSide.entries) +
            if (form.canRotate) listOf(turnHandle(frame)) else emptyList()

        form is Form.Start -> listOf(turnHandle(form.middle, form.pose.heading, form.robot.box.right))
        form is Form.Light && form.turns -> listOf(turnHandle(form.place, form.direction, LAMP_RADIUS))
        else -> emptyList()
    }
}

private fun handlesOfSeveral(forms: List<Form>, frame: SelectionFrame): List<Handle> {
    val sizes = sizeHandles(frame, SizeSide.entries.filter { it.isCorner })
    return (if (forms.any { it is Form.Area || it is Form.Way }) sizes else emptyList()) + turnHandle(frame)
}

private fun sizeHandles(frame: SelectionFrame, sides: List<SizeSide>): List<Handle> =
    sides.map { Handle(DragHandle.Size(it), frame.at(it.across, it.up), frame.outwards(it.across, it.up)) }

private fun cornerHandles(form: Form, frame: SelectionFrame): List<Handle> {
    val none = Point(0.0, 0.0)
    val corners = form.corners.mapIndexed { number, corner -> Handle(DragHandle.Corner(number), corner, none) }
    if ((form as? Form.Way)?.isBent == false) return corners
    val edges = form.edges().mapIndexed {
        number,
        (from, to),
        ->
        Handle(DragHandle.Edge(number), middleOf(from, to), none)
    }
    return (corners + edges).takeIf { frame.width > 0 || frame.height > 0 } ?: corners
}

/** Above all others. */
private fun turnHandle(frame: SelectionFrame) = Handle(DragHandle.Turn, frame.at(0, 1), frame.outwards(0, 1))

/** In the direction of the heading. */
private fun turnHandle(middle: Point, heading: Double, ahead: Double): Handle {
    val direction = Direction(heading)
    return Handle(DragHandle.Turn, direction.from(middle, ahead, 0.0), direction.from(Point(0.0, 0.0), 1.0, 0.0))
}

internal fun middleOf(one: Point, other: Point) = Point((one.x + other.x) / 2, (one.y + other.y) / 2)

/** [point] relative to [origin] and [direction]: the distance ahead and to the left. */
internal fun relativeTo(origin: Point, direction: Direction, point: Point): Point {
    val x = point.x - origin.x
    val y = point.y - origin.y
    return Point(x * direction.cosine + y * direction.sine, y * direction.cosine - x * direction.sine)
}
