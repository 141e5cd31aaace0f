package robotran.nxt.hardware

/** The battery as the brick measures it: in 1024 steps of 13.848 millivolts. */
internal class Battery {
    /** What the brick has measured. */
    var millivolts: Int = measured(FULL_MILLIVOLTS)
        private set

    /** Sets the voltage. */
    fun measure(voltage: Int) {
        millivolts = measured(voltage)
    }

    companion object {
        /** A charged accumulator. */
        const val FULL_MILLIVOLTS = 8_000

        private const val STEP_MICROVOLTS = 13_848L
        private const val MICROVOLTS = 1_000L
        private const val HIGHEST_STEP = 1_023L

        /** The nearest step in millivolts. */
        private fun measured(voltage: Int): Int {
            val step = (voltage * MICROVOLTS + STEP_MICROVOLTS / 2) / STEP_MICROVOLTS
            return (step.coerceIn(0, HIGHEST_STEP) * STEP_MICROVOLTS / MICROVOLTS).toInt()
        }
    }
}
