package robotran.robolang.run

/** The value `timer`. */
internal class ProgramTimer(private val robot: RobotDevice) {
    private var start = robot.milliseconds

    /** `start = (int) System.currentTimeMillis()`. */
    fun reset() {
        start = robot.milliseconds
    }

    /** `((int) System.currentTimeMillis() - start) / 1000f`. */
    fun seconds(): Float = (robot.milliseconds - start).toInt() / MILLI

    private companion object {
        const val MILLI = 1000f
    }
}
