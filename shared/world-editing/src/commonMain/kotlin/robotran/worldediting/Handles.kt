package robotran.worldediting

import robotran.world.Penbot
import robotran.world.World
import robotran.world.file.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/** By what something on the sheet is taken. */
sealed interface DragHandle {
    /** The thing itself: it is moved. */
    data object Body : DragHandle

    data class Size(val side: SizeSide) : DragHandle

    data object Turn : DragHandle

    /** One of the corners of a polygon or points of a line. */
    data class Corner(val number: Int) : DragHandle

    /** The middle between a corner and the next; drawn out, it becomes a corner. */
    data class Edge(val number: Int) : DragHandle
}

/** Where a handle for resizing sits: left or right of the middle ([across] -1 or 1), below or above it ([up]). */
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
 * Something to take a thing by.
 *
 * @property place the point of the thing that it belongs to.
 * @property outwards which way it may be drawn away from that, so that it does not cover the thing; of length 1, or 0
 * for none.
 */
data class Handle(val grip: DragHandle, val place: Point, val outwards: Point)

/** The rectangle, turned by [angle], that handles sit on. */
data class Frame(val centre: Point, val width: Double, val height: Double, val angle: Double) {
    private val direction = Direction(angle)

    /** The point so many halves of its width and height from its centre. */
    fun at(across: Int, up: Int): Point = direction.from(centre, across * width / 2, up * height / 2)

    /** [place] as seen from its centre, along its width and its height. */
    internal fun seen(place: Point): Point = seenFrom(centre, direction, place)

    internal fun outwards(across: Int, up: Int): Point {
        val part = if (across != 0 && up != 0) DIAGONAL else 1.0
        return direction.from(Point(0.0, 0.0), across * part, up * part)
    }

    private companion object {
        const val DIAGONAL = 0.7071
    }
}

/** What is around all of [things]; null if none of them is anywhere. */
fun World.frameOf(things: Set<ElementRef>): Frame? {
    val forms = things.mapNotNull { piece(it)?.form }
    val shape = (forms.singleOrNull() as? Form.Area)?.shape
    if (shape is Shape.Rectangle) return Frame(shape.centre, shape.width, shape.height, shape.angle)
    return around(forms.map { it.bounds })?.let { Frame(it.middle, it.width, it.height, 0.0) }
}

/** All handles that [things] have together. */
fun World.handlesOf(things: Set<ElementRef>): List<Handle> {
    val forms = things.mapNotNull { piece(it)?.form }
    val frame = frameOf(things) ?: return emptyList()
    val form = forms.singleOrNull() ?: return handlesOfSeveral(forms, frame)
    return when {
        form.corners.isNotEmpty() -> cornerHandles(form, frame) + turnHandle(frame)

        form is Form.Area -> sizeHandles(frame, SizeSide.entries) +
            if (form.canTurn) listOf(turnHandle(frame)) else emptyList()

        form is Form.Start -> listOf(turnHandle(form.middle, form.pose.heading, Penbot.BUMPER_FRONT))

        form is Form.Light && form.turns -> listOf(turnHandle(form.place, form.direction, LAMP_RADIUS))

        else -> emptyList()
    }
}

private fun handlesOfSeveral(forms: List<Form>, frame: Frame): List<Handle> {
    val sizes = sizeHandles(frame, SizeSide.entries.filter { it.isCorner })
    return (if (forms.any { it is Form.Area || it is Form.Way }) sizes else emptyList()) + turnHandle(frame)
}

private fun sizeHandles(frame: Frame, sides: List<SizeSide>): List<Handle> =
    sides.map { Handle(DragHandle.Size(it), frame.at(it.across, it.up), frame.outwards(it.across, it.up)) }

private fun cornerHandles(form: Form, frame: Frame): List<Handle> {
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

/** Above everything. */
private fun turnHandle(frame: Frame) = Handle(DragHandle.Turn, frame.at(0, 1), frame.outwards(0, 1))

/** Where somebody looks. */
private fun turnHandle(middle: Point, heading: Double, ahead: Double): Handle {
    val direction = Direction(heading)
    return Handle(DragHandle.Turn, direction.from(middle, ahead, 0.0), direction.from(Point(0.0, 0.0), 1.0, 0.0))
}

internal fun middleOf(one: Point, other: Point) = Point((one.x + other.x) / 2, (one.y + other.y) / 2)

/** [place] as it is seen from [origin] by somebody who looks in [direction]: how far ahead and how far to the left. */
internal fun seenFrom(origin: Point, direction: Direction, place: Point): Point {
    val x = place.x - origin.x
    val y = place.y - origin.y
    return Point(x * direction.cosine + y * direction.sine, y * direction.cosine - x * direction.sine)
}
