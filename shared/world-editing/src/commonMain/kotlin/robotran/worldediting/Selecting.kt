package robotran.worldediting

import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point

/** The elements within [reach] of [point], topmost first; a small element comes before one that contains it. */
fun World.elementsAt(point: Point, reach: Double): List<ElementRef> = things().asReversed().mapNotNull { thing ->
    val distance = piece(thing)?.form?.distanceTo(point)
    thing.takeIf { distance != null && distance <= reach }?.let { it to checkNotNull(distance) }
}.sortedBy { (_, distance) -> if (distance == 0.0) 0.0 else distance }.map { it.first }

/** The elements completely inside [area]. */
fun World.elementsWithin(area: Bounds): Set<ElementRef> =
    things().filter { thing -> piece(thing)?.form?.let { it.bounds in area } == true }.toSet()

/** The elements in list and Tab order: the pupil's robot first. */
fun World.listed(): List<ElementRef> = LISTED.flatMap { kind -> List(count(kind)) { ElementRef(kind, it) } }

private val LISTED = listOf(
    ElementKind.ROBOT,
    ElementKind.WALL,
    ElementKind.BARRIER,
    ElementKind.BLOCK,
    ElementKind.MARK,
    ElementKind.STROKE,
    ElementKind.LAMP,
    ElementKind.GOAL,
)

/** [things] and all elements in a group with any of them. */
internal fun withGroups(things: Set<ElementRef>, groups: List<Set<ElementRef>>): Set<ElementRef> =
    things + groups.filter { group -> group.any { it in things } }.flatten()
