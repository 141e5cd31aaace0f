package robotran.simulation

import robotran.brick.Brick
import robotran.brick.controls.BrickButton
import robotran.brick.program.BrickProgram
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.roundToThousandths

/**
 * An external input to a running session by the user; recorded with its time, so that a run can be replayed. Robots,
 * blocks and lamps are identified by their indices in the world; an input for a missing one does nothing.
 */
sealed interface SessionInput {
    /** Presses a button of a brick. */
    data class Press(val button: BrickButton, val robot: Int = 0) : SessionInput

    /** Releases a button of a brick. */
    data class Release(val button: BrickButton, val robot: Int = 0) : SessionInput

    /**
     * The stop button beside the world. Ends the programs of all robots, which no single button of a real brick does;
     * clears a displayed failure, like On-Off.
     */
    data object Stop : SessionInput

    /**
     * Sends [program] to a brick and runs it at once, see [Brick.runSnippet]. From then on the goals keep their progress,
     * because what the robots do is no longer the work of their programs alone.
     */
    data class RunSnippet(val program: BrickProgram, val robot: Int = 0) : SessionInput

    /** Picks a robot up and puts it down elsewhere; positions beside the paper are clamped to its edge. */
    data class PlaceRobot(val robot: Int, val pose: Pose) : SessionInput

    /**
     * Picks a block up and puts it down elsewhere, at rest: with its centre, see [Shape.centre], at the point of
     * [pose], rotated by the heading from its initial orientation. Positions beside the paper are clamped to its edge.
     * If the space is occupied, the block lands beside it.
     */
    data class PlaceBlock(val block: Int, val pose: Pose) : SessionInput

    data class MoveLamp(val lamp: Int, val place: Point) : SessionInput

    data class SwitchLamp(val lamp: Int, val on: Boolean) : SessionInput

    /** Changes the ambient light, as a blind does; in the units of [Light], negative values count as none. */
    data class ChangeAmbientLight(val light: Double) : SessionInput

    /** Changes the temperature, in degrees Celsius. */
    data class ChangeTemperature(val celsius: Double) : SessionInput

    /** Presses or releases the touch sensor on the input port [port], from 0, of a robot. */
    data class TouchSensor(val robot: Int, val port: Int, val pressed: Boolean) : SessionInput
}

/**
 * The input with positions, angles and amounts rounded to thousandths, the precision of a file, so that a saved run
 * replays the same.
 */
internal fun SessionInput.inThousandths(): SessionInput = when (this) {
    is SessionInput.PlaceRobot -> copy(pose = pose.inThousandths())
    is SessionInput.PlaceBlock -> copy(pose = pose.inThousandths())
    is SessionInput.MoveLamp -> copy(place = Point(roundToThousandths(place.x), roundToThousandths(place.y)))
    is SessionInput.ChangeAmbientLight -> copy(light = roundToThousandths(light))
    is SessionInput.ChangeTemperature -> copy(celsius = roundToThousandths(celsius))
    is SessionInput.Press,
    is SessionInput.Release,
    is SessionInput.SwitchLamp,
    is SessionInput.TouchSensor,
    is SessionInput.RunSnippet,
    SessionInput.Stop,
    -> this
}

private fun Pose.inThousandths() = Pose(roundToThousandths(x), roundToThousandths(y), roundToThousandths(heading))
