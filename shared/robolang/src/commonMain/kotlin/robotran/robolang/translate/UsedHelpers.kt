package robotran.robolang.translate

import robotran.robolang.robot.Calibration
import robotran.robolang.robot.Durations

/** Which helpers a translation needs: only those are written. */
internal class UsedHelpers(calibration: Calibration, val isReacting: Boolean) {
    private val used = mutableSetOf<JavaHelper>()

    /** For what is worked out before the run. */
    val durations = Durations(calibration)

    /** The helpers that are needed, in the order they are declared in. */
    val all: List<JavaHelper> get() = JavaHelper.entries.filter { it in used }

    init {
        if (isReacting) listOf(JavaHelper.PAUSE, JavaHelper.PAUSE_IN_CONTROL).forEach(::use)
    }

    /** The Java that lets so many milliseconds pass. */
    fun sleep(milliseconds: Int): String = if (isReacting) "pause($milliseconds);" else "Thread.sleep($milliseconds);"

    /** Notes that [helper], and what it needs itself, is wanted; the answer is how the program calls it. */
    fun use(helper: JavaHelper): String {
        if (used.add(helper)) helper.needs.forEach(::use)
        return if (helper.isCalculation) "${JavaHelper.CALCULATION}.${helper.called}" else helper.called
    }
}
