package robotran.robolang.translate

import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget

/** Collects the helpers that a translation uses; only those are written. */
internal class UsedHelpers(private val robot: RobotTarget, val isReacting: Boolean) {
    private val used = mutableSetOf<JavaHelper>()

    /** For constants. */
    val durations = Durations(robot)

    /** The used helpers, in order of declaration. */
    val all: List<JavaHelper> get() = JavaHelper.entries.filter { it in used }

    init {
        if (isReacting) listOf(JavaHelper.PAUSE, JavaHelper.PAUSE_IN_CONTROL).forEach(::use)
    }

    /** The Java that waits for so many milliseconds. */
    fun sleep(milliseconds: Int): String = if (isReacting) "pause($milliseconds);" else "Thread.sleep($milliseconds);"

    /** Marks [helper] and its dependencies as used; returns the name to call it by. */
    fun use(helper: JavaHelper): String {
        if (used.add(helper)) helper.needsOn(robot.kind, isReacting).forEach(::use)
        return if (helper.isCalculation) "${JavaHelper.CALCULATION}.${helper.called}" else helper.called
    }
}
