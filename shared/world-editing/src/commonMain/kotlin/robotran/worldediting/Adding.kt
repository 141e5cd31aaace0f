package robotran.worldediting

import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.simplified

/**
 * Adds [element] near [at] and selects it: what stands where no other thing stands, and with [inSight] anything where
 * there is nothing else.
 */
internal fun WorldEditing.put(element: Element, at: Point, inSight: Bounds?): Outcome? {
    val form = element.form ?: return null
    val corner = Point(form.bounds.left, form.bounds.bottom)
    val middle = form.bounds.middle
    val there = snapping.onGrid(Point(at.x + corner.x - middle.x, at.y + corner.y - middle.y))
    val placed = form.movedBy(there.x - corner.x, there.y - corner.y)
    val free = inSight?.let { world.inFreeRoom(element, placed, it) } ?: world.freeFormFor(placed, element.kind)
    return added(listOf(element.withForm(free)), Point(0.0, 0.0))
}

internal fun WorldEditing.pasted(at: Point?): Outcome? {
    if (at == null) return added(clipboard, Point(STEP_ASIDE, -STEP_ASIDE))
    val middle = around(clipboard.mapNotNull { it.form?.bounds })?.middle ?: return added(clipboard, Point(0.0, 0.0))
    return added(clipboard, snapping.onGrid(Point(at.x - middle.x, at.y - middle.y)))
}

/** Adds a line that was drawn by hand, with as few points as possible. */
internal fun WorldEditing.drawn(points: List<Point>): Outcome? {
    val line = simplified(points.map(Point::rounded), HAND_TOLERANCE)
    if (line.size < 2) return null
    val piece = when (tool) {
        Tool.DRAW_TEMPLATE -> Element.OfStroke(line)
        Tool.DRAW_LINE -> Element.OfMark(Mark(MarkFigure.Line(line, LINE_WIDTH)))
        Tool.SELECT -> return null
    }
    return added(listOf(piece), Point(0.0, 0.0))
}

/** Adds [pieces], moved by [aside], on top of the others, with unique names, and selects them. */
internal fun WorldEditing.added(pieces: List<Element>, aside: Point): Outcome? {
    if (pieces.isEmpty()) return null
    var now = world
    val taken = world.names().values.toMutableSet()
    val new = mutableSetOf<ElementRef>()
    for (piece in pieces) {
        val name = piece.name?.let { uniqueName(it, taken) }
        if (name != null) taken += name
        val moved = piece.form?.movedBy(aside.x, aside.y)?.let(piece::withForm) ?: piece
        val own = moved.named(name).tidied().separate()
        errorOf(own)?.let { return Outcome.Not(it) }
        new += ElementRef(own.kind, now.count(own.kind))
        now = now.plus(own)
    }
    return Outcome.Made(WorldSnapshot(now, new, groups))
}

/** A copy of a goal must be a different object, see [renumbered]. */
private fun Element.separate(): Element = if (this is Element.OfGoal) Element.OfGoal(goal.separate()) else this

/** [form] at its own position or, if it overlaps a robot or an obstacle, at the nearest free one. */
private fun World.freeFormFor(form: Form, kind: ElementKind): Form {
    if (kind !in STANDING) return form.takeIf { isFree(it, setOf(kind), margin = SAME_PLACE) } ?: aside(form, kind)
    val places = sequenceOf(Point(0.0, 0.0)) + (1..MAX_RINGS).asSequence().flatMap { ring ->
        (0..<DIRECTIONS).asSequence().map {
            Direction(it * FULL_TURN / DIRECTIONS).from(Point(0.0, 0.0), ring * RING, 0.0)
        }
    }
    return places.map { form.movedBy(it.x, it.y) }
        .firstOrNull { paperBounds.contains(it.middle.x, it.middle.y) && isFree(it, STANDING, 0.0) } ?: form
}

/** An element may overlap others on the paper, but must not coincide with one of its kind. */
private fun World.aside(form: Form, kind: ElementKind): Form = (1..MAX_RINGS).asSequence()
    .map { form.movedBy(it * STEP_ASIDE, -it * STEP_ASIDE) }
    .firstOrNull { isFree(it, setOf(kind), SAME_PLACE) } ?: form

/** Whether nothing of [kinds] overlaps [form]; with a negative [margin] only nearly equal bounds count as overlap. */
private fun World.isFree(form: Form, kinds: Set<ElementKind>, margin: Double): Boolean {
    val bounds = form.bounds
    return things().filter { it.kind in kinds }.mapNotNull { piece(it)?.form?.bounds }.none { other ->
        if (margin < 0) isSame(bounds, other) else meet(bounds, other)
    }
}

private fun isSame(one: Bounds, other: Bounds) =
    listOf(one.left - other.left, one.right - other.right, one.bottom - other.bottom, one.top - other.top)
        .all { it in SAME_PLACE..-SAME_PLACE }

private val World.paperBounds: Bounds get() = Bounds(0.0, 0.0, paper.width, paper.height)

private val STANDING = setOf(ElementKind.ROBOT, ElementKind.WALL, ElementKind.BARRIER, ElementKind.BLOCK)
private const val SAME_PLACE = -0.5
private const val RING = 5.0
private const val MAX_RINGS = 20
private const val DIRECTIONS = 12
private const val FULL_TURN = 360.0

/** Max distance of a stored line from the line drawn by hand, in centimetres. */
private const val HAND_TOLERANCE = 0.25

/** Wide enough for a light sensor to follow. */
internal const val LINE_WIDTH = 2.0
