package robotran.microbit.buggy

/** What a port of a buggy has. */
sealed interface MicrobitSensor {
    /** The line sensor number [line] of the buggy, from 0 on the left. */
    data class Line(val line: Int) : MicrobitSensor

    /** Its distance sensor. */
    data object Sonar : MicrobitSensor
}
