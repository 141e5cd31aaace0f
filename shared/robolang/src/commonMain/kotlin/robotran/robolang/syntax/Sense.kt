package robotran.robolang.syntax

/** The sensors of the robot, and other readings of the brick. */
internal sealed interface Sense {
    /** `left bumper`, on port 1. */
    data object LeftBumper : Sense

    /** `right bumper`, on port 3. */
    data object RightBumper : Sense

    /** `light`, 0..100, on the port that the header names, otherwise 2. */
    data object Light : Sense

    /** `sensor 1`: the canonical value on [port] 1..3. */
    data class Sensor(val port: Int) : Sense

    /** `button run`: whether it is held down. */
    data class Button(val button: BrickButton) : Sense

    /** `timer`, in seconds since the start or the last `reset timer`. */
    data object Timer : Sense

    /** `battery`, in volts. */
    data object Battery : Sense
}

internal enum class BrickButton { RUN, VIEW, PRGM }
