package robotran.ui.world

import robotran.simulation.state.SessionState
import robotran.ui.sheet.corners
import robotran.ui.sheet.distance
import robotran.ui.sheet.towards
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.centre
import robotran.world.robot.box
import kotlin.math.PI

/** The elements that can be moved while the world runs. */
internal val MOVABLE = setOf(SheetElementKind.ROBOT, SheetElementKind.BLOCK, SheetElementKind.LAMP)

/** All of them, in the order of keyboard focus. */
internal fun movableElements(world: World): List<SheetElement> =
    world.robots.indices.map { SheetElement(SheetElementKind.ROBOT, it) } +
        world.blocks.indices.map { SheetElement(SheetElementKind.BLOCK, it) } +
        world.lamps.indices.map { SheetElement(SheetElementKind.LAMP, it) }

/** The pose of a movable element at its pen or centre; null if it does not exist. */
internal fun poseOf(thing: SheetElement, world: World, session: SessionState): Pose? = when (thing.kind) {
    SheetElementKind.ROBOT -> session.robots.getOrNull(thing.number)?.robot?.pose

    SheetElementKind.BLOCK -> session.blocks.getOrNull(thing.number)?.let { moved ->
        world.blocks.getOrNull(thing.number)?.shape?.centre?.let { Pose(it.x + moved.x, it.y + moved.y, moved.heading) }
    }

    SheetElementKind.LAMP -> session.lamps.getOrNull(thing.number)?.let { Pose(it.place.x, it.place.y, 0.0) }
    else -> null
}

/** The radius of a movable element around that point. */
internal fun reachOf(thing: SheetElement, world: World): Double = when (thing.kind) {
    SheetElementKind.ROBOT -> (world.robots.getOrNull(thing.number) ?: world.robots.first()).description.box.right + 1

    SheetElementKind.BLOCK -> {
        world.blocks.getOrNull(thing.number)?.shape?.let { shape ->
            shape.corners().maxOf { distance(it, shape.centre) }
        }
            ?: 0.0
    }

    else -> LAMP_REACH
}

/** The position of the handle for turning a robot or a block; null for other elements. */
internal fun handleOf(thing: SheetElement, world: World, session: SessionState): Point? {
    if (thing.kind == SheetElementKind.LAMP) return null
    val pose = poseOf(thing, world, session) ?: return null
    return Point(pose.x, pose.y).towards(pose.heading * PI / HALF_TURN, reachOf(thing, world) + HANDLE_DISTANCE)
}

/** The radius of the handle and its distance from the element. */
internal const val HANDLE_CENTIMETRES = 1.2
private const val HANDLE_DISTANCE = 4.0
private const val LAMP_REACH = 2.4
private const val HALF_TURN = 180.0
