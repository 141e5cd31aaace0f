package robotran.simulation.robot

/** The play between a motor and its wheel: a motor that changes direction turns by [width] before the wheel follows. */
internal class MotorPlay(private val width: Double) {
    /** Where the motor is within the play. */
    private var place = 0.0

    /** How much of the motor's way the wheel has not followed, unsigned. */
    var lost = 0.0
        private set

    /** The part of the motor's [way] that reaches the wheel. */
    fun passOn(way: Double): Double {
        val wanted = place + way
        place = wanted.coerceIn(0.0, width)
        val passed = wanted - place
        val kept = way - passed
        lost += if (kept < 0) -kept else kept
        return passed
    }
}
