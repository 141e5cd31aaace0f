package robotran.robotediting

import robotran.world.BumperPart
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.things

/** What can be chosen on a robot. Numbers are indices from 0. */
sealed interface RobotElement {
    /** A bumper or sensor, by its index in [things]; it may have several cables. */
    data class Part(val number: Int) : RobotElement

    data class Caster(val number: Int) : RobotElement

    /** A corner of the chassis. */
    data class Corner(val number: Int) : RobotElement

    data object Wheels : RobotElement

    data object Pen : RobotElement

    data object Brick : RobotElement

    data object Mass : RobotElement

    data object Chassis : RobotElement
}

/** All elements in the order in which keys and screen readers go through them, without the corners. */
fun RobotDescription.elements(): List<RobotElement> = things.indices.map { RobotElement.Part(it) } +
    RobotElement.Wheels +
    casters.indices.map { RobotElement.Caster(it) } +
    listOfNotNull(RobotElement.Pen.takeIf { pen != null }) +
    listOf(RobotElement.Brick, RobotElement.Mass, RobotElement.Chassis)

fun RobotDescription.has(element: RobotElement): Boolean = when (element) {
    is RobotElement.Part -> element.number in things.indices
    is RobotElement.Caster -> element.number in casters.indices
    is RobotElement.Corner -> element.number in chassis.outline.indices
    RobotElement.Pen -> pen != null
    RobotElement.Wheels, RobotElement.Brick, RobotElement.Mass, RobotElement.Chassis -> true
}

/** The place that moves with the element; null if it has none of its own, such as the wheels or a rotation sensor. */
fun RobotDescription.placeOf(element: RobotElement): Point? = when (element) {
    is RobotElement.Part -> things.getOrNull(element.number)?.place
    is RobotElement.Caster -> casters.getOrNull(element.number)
    is RobotElement.Corner -> chassis.outline.getOrNull(element.number)
    RobotElement.Brick -> brickAt.at
    RobotElement.Mass -> chassis.massAt
    RobotElement.Pen -> Point(0.0, 0.0).takeIf { pen != null }
    RobotElement.Wheels, RobotElement.Chassis -> null
}

/** The ports on which the thing with this index is, in the order of its cables. */
fun RobotDescription.portsOf(number: Int): List<Int> {
    val thing = things.getOrNull(number)?.on(null) ?: return emptyList()
    return parts.filter { it.on(null) == thing }.mapNotNull { it.port }
}

/** The things on [port], by their indices in [things]. */
fun RobotDescription.thingsOn(port: Int): List<Int> = things.indices.filter { port in portsOf(it) }

/** The lowest port without anything on it; null if there is none. */
val RobotDescription.freePort: Int? get() = (1..brick.inputPorts).firstOrNull { port -> parts.none { it.port == port } }

/** The index in [things] of the thing that the entry [entry] of [RobotDescription.parts] is a cable of. */
fun RobotDescription.thingOfEntry(entry: Int): Int? =
    parts.getOrNull(entry)?.let { part -> things.indexOfFirst { it.on(null) == part.on(null) } }?.takeIf { it >= 0 }

internal val RobotPart.place: Point?
    get() = when (this) {
        is BumperPart -> at
        is SensorPart -> at
        else -> null
    }

/**
 * The same robot with [change] done to a thing, whose cables stay where they are; null if that made it the same thing
 * as another one.
 */
fun RobotDescription.withThing(number: Int, change: (RobotPart) -> RobotPart): RobotDescription? {
    val before = things.getOrNull(number)?.on(null) ?: return null
    val after = change(before).on(null)
    if (after == before) return this
    if (things.any { it.on(null) == after }) return null
    return copy(parts = parts.map { if (it.on(null) == before) after.on(it.port) else it })
}
