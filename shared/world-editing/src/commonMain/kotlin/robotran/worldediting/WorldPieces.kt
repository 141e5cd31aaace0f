package robotran.worldediting

import robotran.world.Template
import robotran.world.World
import robotran.world.geometry.Point

/** The lines of the template. */
val World.strokes: List<List<Point>> get() = template?.strokes.orEmpty()

fun World.count(kind: ElementKind): Int = when (kind) {
    ElementKind.MARK -> marks.size
    ElementKind.STROKE -> strokes.size
    ElementKind.GOAL -> allGoals(goals).size
    ElementKind.WALL -> walls.size
    ElementKind.BARRIER -> barriers.size
    ElementKind.BLOCK -> blocks.size
    ElementKind.ROBOT -> robots.size
    ElementKind.LAMP -> lamps.size
}

/** All elements, from the bottom up, those of a kind in their own order. */
fun World.things(): List<ElementRef> = ElementKind.entries.flatMap { kind ->
    List(count(kind)) { ElementRef(kind, it) }
}

/** The element for [thing]; null if it is missing. */
fun World.piece(thing: ElementRef): Element? = when (thing.kind) {
    ElementKind.MARK -> marks.getOrNull(thing.number)?.let(Element::OfMark)
    ElementKind.STROKE -> strokes.getOrNull(thing.number)?.let(Element::OfStroke)
    ElementKind.GOAL -> allGoals(goals).getOrNull(thing.number)?.let { Element.OfGoal(it.goal) }
    ElementKind.WALL -> walls.getOrNull(thing.number)?.let(Element::OfWall)
    ElementKind.BARRIER -> barriers.getOrNull(thing.number)?.let(Element::OfBarrier)
    ElementKind.BLOCK -> blocks.getOrNull(thing.number)?.let(Element::OfBlock)
    ElementKind.ROBOT -> robots.getOrNull(thing.number)?.let(Element::OfRobot)
    ElementKind.LAMP -> lamps.getOrNull(thing.number)?.let(Element::OfLamp)
}

/** Replaces the element of its kind at index [number] by [piece]; the parts of a group of goals stay unchanged. */
internal fun World.with(number: Int, piece: Element): World = when (piece) {
    is Element.OfRobot -> copy(robots = robots.with(number, piece.robot))
    is Element.OfWall -> copy(walls = walls.with(number, piece.wall))
    is Element.OfBarrier -> copy(barriers = barriers.with(number, piece.barrier))
    is Element.OfBlock -> copy(blocks = blocks.with(number, piece.block))
    is Element.OfMark -> copy(marks = marks.with(number, piece.mark))
    is Element.OfLamp -> copy(lamps = lamps.with(number, piece.lamp))
    is Element.OfStroke -> copy(template = template?.copy(strokes = strokes.with(number, piece.points)))

    is Element.OfGoal -> copy(
        goals = goals.changed { place, goal ->
            if (place == number) {
                piece.goal.withParts(goal.parts)
            } else {
                goal
            }
        },
    )
}

/** Adds [piece] on top of the others of its kind. */
internal fun World.plus(piece: Element): World = when (piece) {
    is Element.OfRobot -> copy(robots = robots + piece.robot)
    is Element.OfWall -> copy(walls = walls + piece.wall)
    is Element.OfBarrier -> copy(barriers = barriers + piece.barrier)
    is Element.OfBlock -> copy(blocks = blocks + piece.block)
    is Element.OfMark -> copy(marks = marks + piece.mark)
    is Element.OfLamp -> copy(lamps = lamps + piece.lamp)

    is Element.OfStroke -> copy(
        template = (template ?: Template(emptyList())).let { it.copy(strokes = it.strokes + listOf(piece.points)) },
    )

    is Element.OfGoal -> copy(goals = goals + piece.goal)
}

/** Removes [things]; nested goals are removed with their group, and a template without lines becomes null. */
internal fun World.without(things: Set<ElementRef>): World {
    fun <T> List<T>.without(kind: ElementKind) = filterIndexed { number, _ -> ElementRef(kind, number) !in things }
    return copy(
        robots = robots.without(ElementKind.ROBOT),
        walls = walls.without(ElementKind.WALL),
        barriers = barriers.without(ElementKind.BARRIER),
        blocks = blocks.without(ElementKind.BLOCK),
        marks = marks.without(ElementKind.MARK),
        lamps = lamps.without(ElementKind.LAMP),
        template = template?.let {
            it.copy(strokes = it.strokes.without(ElementKind.STROKE))
        }?.takeIf { it.strokes.isNotEmpty() },
        goals = goals.changed { number, goal -> goal.takeIf { ElementRef(ElementKind.GOAL, number) !in things } },
    )
}

/** This list with [item] at index [place], if the index is valid. */
internal fun <T> List<T>.with(place: Int, item: T): List<T> = mapIndexed { number, old ->
    if (number == place) {
        item
    } else {
        old
    }
}
