package robotran.ui.world

import robotran.simulation.SessionInput
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetTouch
import robotran.ui.sheet.distance
import robotran.ui.sheet.elementAt
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.round

/**
 * Manual changes to a running world: drags robots, blocks and lamps, turns robots and blocks by their handle, and
 * switches lamps by a tap.
 *
 * @param now the current session and the element with a handle.
 * @param choose selects the element with a handle.
 * @param inputs receives the session inputs.
 */
internal class HandTouch(
    private val world: World,
    private val now: () -> Pair<SessionState, SheetElement?>,
    private val choose: (SheetElement?) -> Unit,
    private val inputs: FrameThrottledInput,
) : SheetTouch {
    private var held: Held? = null

    override fun take(point: Point, tolerance: Double): Boolean {
        val (session, chosen) = now()
        held = handleAt(point, chosen, session, tolerance) ?: grip(point, session, tolerance)
        return held != null
    }

    override fun drag(point: Point) {
        val grip = held ?: return
        val session = now().first
        val pose = poseOf(grip.thing, world, session) ?: return
        inputs.send(
            when (grip) {
                is Held.Body -> placing(grip.thing, pose.copy(x = point.x + grip.offset.x, y = point.y + grip.offset.y))

                is Held.Handle -> placing(
                    grip.thing,
                    pose.copy(heading = round(angle(Point(pose.x, pose.y), point) + grip.turn)),
                )
            },
        )
    }

    override fun letGo() {
        held = null
        inputs.flush()
    }

    override fun tap(point: Point, tolerance: Double): Boolean {
        val (session, chosen) = now()
        if (handleAt(point, chosen, session, tolerance) != null) return true
        val thing = elementAt(world, session, point, tolerance, MOVABLE)
        choose(thing)
        if (thing?.kind == SheetElementKind.LAMP) {
            inputs.sendNow(SessionInput.SwitchLamp(thing.number, !session.lamps[thing.number].on))
        }
        return thing != null
    }

    private fun handleAt(point: Point, chosen: SheetElement?, session: SessionState, tolerance: Double): Held? {
        if (chosen == null || chosen.kind == SheetElementKind.LAMP) return null
        val pose = poseOf(chosen, world, session) ?: return null
        val handle = handleOf(chosen, world, session) ?: return null
        if (distance(handle, point) > tolerance + HANDLE_CENTIMETRES) return null
        return Held.Handle(chosen, pose.heading - angle(Point(pose.x, pose.y), point))
    }

    private fun grip(point: Point, session: SessionState, tolerance: Double): Held? {
        val thing = elementAt(world, session, point, tolerance, MOVABLE) ?: return null
        val pose = poseOf(thing, world, session) ?: return null
        choose(thing)
        return Held.Body(thing, Point(pose.x - point.x, pose.y - point.y))
    }

    private fun angle(from: Point, to: Point) = atan2(to.y - from.y, to.x - from.x) * DEGREES_PER_RADIAN

    private sealed interface Held {
        val thing: SheetElement

        /** @property offset from the finger to the centre of the element. */
        class Body(override val thing: SheetElement, val offset: Point) : Held

        /** @property turn from the direction of the finger to the element's heading. */
        class Handle(override val thing: SheetElement, val turn: Double) : Held
    }

    private companion object {
        const val DEGREES_PER_RADIAN = 180 / PI
    }
}

/** The input that moves [thing] to [pose], see [poseOf]. */
internal fun placing(thing: SheetElement, pose: Pose): SessionInput {
    val upright = pose.copy(heading = headingOf(pose.heading))
    return when (thing.kind) {
        SheetElementKind.ROBOT -> SessionInput.PlaceRobot(thing.number, upright)
        SheetElementKind.BLOCK -> SessionInput.PlaceBlock(thing.number, upright)
        else -> SessionInput.MoveLamp(thing.number, Point(pose.x, pose.y))
    }
}

/** Normalises a direction to above -180 and up to 180 degrees. */
private fun headingOf(degrees: Double): Double = (degrees % FULL_TURN).let {
    when {
        it > FULL_TURN / 2 -> it - FULL_TURN
        it <= -FULL_TURN / 2 -> it + FULL_TURN
        else -> it
    }
}

private const val FULL_TURN = 360.0
