package robotran.simulation

import robotran.rcxrom.controls.BrickButton
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.roundToThousandths

/**
 * What a person does to a running session from outside; recorded with its time, so that a run can be repeated. Robots,
 * blocks and lamps are known by their numbers in the world, from 0; an input for one that is not there does nothing.
 */
sealed interface SessionInput {
    /** A finger goes down on a button of a brick. */
    data class Press(val button: BrickButton, val robot: Int = 0) : SessionInput

    /** The finger comes off it. */
    data class Release(val button: BrickButton, val robot: Int = 0) : SessionInput

    /**
     * The stop button beside the world: ends the programs of all robots, as no single button of a real brick does; ends
     * the showing of a failure, as On-Off does.
     */
    data object Stop : SessionInput

    /** A robot is picked up and put down elsewhere; what is beside the paper counts as its nearest edge. */
    data class PlaceRobot(val robot: Int, val pose: Pose) : SessionInput

    /**
     * A block is picked up and put down elsewhere, at rest: its middle, see [Shape.centre], at the place of [pose],
     * turned by the heading from how the world has it. Beside the paper counts as its nearest edge; where something is
     * in the way, the block comes to lie beside it.
     */
    data class PlaceBlock(val block: Int, val pose: Pose) : SessionInput

    /** A lamp is moved. */
    data class MoveLamp(val lamp: Int, val place: Point) : SessionInput

    /** A lamp is switched on or off. */
    data class SwitchLamp(val lamp: Int, val on: Boolean) : SessionInput

    /**
     * The light everywhere changes, as when a blind is pulled down; in the units of [Light], negative counts as none.
     */
    data class ChangeAmbientLight(val light: Double) : SessionInput

    /** It gets warmer or colder; in degrees Celsius. */
    data class ChangeTemperature(val celsius: Double) : SessionInput

    /** A finger presses the touch sensor on the input port [port], 0..2, of a robot, or lets it go. */
    data class TouchSensor(val robot: Int, val port: Int, val pressed: Boolean) : SessionInput
}

/**
 * The input with its places, angles and amounts in thousandths, as a file can keep them, so that a run is the same
 * after it was saved.
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
    SessionInput.Stop,
    -> this
}

private fun Pose.inThousandths() = Pose(roundToThousandths(x), roundToThousandths(y), roundToThousandths(heading))
