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

/** The element for [ref]; null if it is missing. */
fun World.piece(ref: ElementRef): Element? = when (ref.kind) {
    ElementKind.MARK -> marks.getOrNull(ref.number)?.let(Element::OfMark)
    ElementKind.STROKE -> strokes.getOrNull(ref.number)?.let(Element::OfStroke)
    ElementKind.GOAL -> allGoals(goals).getOrNull(ref.number)?.let { Element.OfGoal(it.goal) }
    ElementKind.WALL -> walls.getOrNull(ref.number)?.let(Element::OfWall)
    ElementKind.BARRIER -> barriers.getOrNull(ref.number)?.let(Element::OfBarrier)
    ElementKind.BLOCK -> blocks.getOrNull(ref.number)?.let(Element::OfBlock)
    ElementKind.ROBOT -> robots.getOrNull(ref.number)?.let(Element::OfRobot)
    ElementKind.LAMP -> lamps.getOrNull(ref.number)?.let(Element::OfLamp)
}

/** Replaces the element of its kind at index [number] by [element]; the parts of a group of goals stay unchanged. */
internal fun World.with(number: Int, element: Element): World = when (element) {
    is Element.OfRobot -> copy(robots = robots.with(number, element.robot))
    is Element.OfWall -> copy(walls = walls.with(number, element.wall))
    is Element.OfBarrier -> copy(barriers = barriers.with(number, element.barrier))
    is Element.OfBlock -> copy(blocks = blocks.with(number, element.block))
    is Element.OfMark -> copy(marks = marks.with(number, element.mark))
    is Element.OfLamp -> copy(lamps = lamps.with(number, element.lamp))
    is Element.OfStroke -> copy(template = template?.copy(strokes = strokes.with(number, element.points)))

    is Element.OfGoal -> copy(
        goals = goals.changed { place, goal ->
            if (place == number) {
                element.goal.withParts(goal.parts)
            } else {
                goal
            }
        },
    )
}

/** Adds [element] on top of the others of its kind. */
internal fun World.plus(element: Element): World = when (element) {
    is Element.OfRobot -> copy(robots = robots + element.robot)
    is Element.OfWall -> copy(walls = walls + element.wall)
    is Element.OfBarrier -> copy(barriers = barriers + element.barrier)
    is Element.OfBlock -> copy(blocks = blocks + element.block)
    is Element.OfMark -> copy(marks = marks + element.mark)
    is Element.OfLamp -> copy(lamps = lamps + element.lamp)

    is Element.OfStroke -> copy(
        template = (template ?: Template(emptyList())).let { it.copy(strokes = it.strokes + listOf(element.points)) },
    )

    is Element.OfGoal -> copy(goals = goals + element.goal)
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

/** This list with [item] at index [index], if the index is valid. */
internal fun <T> List<T>.with(index: Int, item: T): List<T> = mapIndexed { number, old ->
    if (number == index) {
        item
    } else {
        old
    }
}
