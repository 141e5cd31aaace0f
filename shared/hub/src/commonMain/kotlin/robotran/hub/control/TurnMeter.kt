package robotran.hub.control

import robotran.hub.control.ControlConstants.PERIOD

/** Where a motor is and how fast, as its hub knows it from the encoder. */
internal class TurnMeter {
    private val past = DoubleArray(ControlConstants.SPEED_WINDOW / PERIOD)
    private var place = 0

    /** Degrees since the beginning of time, clockwise positive. */
    var degrees = 0.0

    /** Degrees a second since the last sample. */
    var speed = 0.0
        private set

    /** Degrees a second in the last [ControlConstants.SPEED_WINDOW] milliseconds. */
    var meanSpeed = 0.0
        private set

    /** Call it every [PERIOD] milliseconds. */
    fun sample() {
        val last = past[(place + past.size - 1) % past.size]
        speed = (degrees - last) / ControlConstants.PERIOD_SECONDS
        meanSpeed = (degrees - past[place]) * SECOND / ControlConstants.SPEED_WINDOW
        past[place] = degrees
        place = (place + 1) % past.size
    }

    private companion object {
        const val SECOND = 1000
    }
}
