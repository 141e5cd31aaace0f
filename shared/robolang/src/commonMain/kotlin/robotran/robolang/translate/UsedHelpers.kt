package robotran.robolang.translate

import robotran.robolang.robot.Durations
import robotran.robolang.template.fillIn

/** Collects the helpers that a translation uses; only those are written. */
internal class UsedHelpers(private val dialect: JavaDialect, val isReacting: Boolean) {
    private val used = mutableSetOf<JavaHelper>()

    /** What the motors of the robot are called. */
    val motors = JavaMotors(dialect.robot)

    /** For constants. */
    val durations = Durations(dialect.robot)

    private val values: Map<String, String> by lazy {
        dialect.parameters(isReacting) + ("THROWS" to throwsClause(isReacting))
    }

    /** The used helpers, in order of declaration. */
    val all: List<JavaHelper> get() = JavaHelper.entries.filter { it in used }

    init {
        if (isReacting) listOf(JavaHelper.PAUSE, JavaHelper.PAUSE_IN_CONTROL).forEach(::use)
    }

    /** The Java of [helper] for the robot. */
    fun textOf(helper: JavaHelper): String {
        val text = JavaTemplates.of(helper.name, dialect.robot.kind, isReacting).fillIn(values)
        return dialect.withMotors(helper, text, motors, isReacting)
    }

    /** The Java that waits for so many milliseconds. */
    fun sleep(milliseconds: Int): String = if (isReacting) "pause($milliseconds);" else "Thread.sleep($milliseconds);"

    /** Marks [helper] and its dependencies as used; returns the name to call it by. */
    fun use(helper: JavaHelper): String {
        if (used.add(helper)) dialect.needsOf(helper, isReacting).forEach(::use)
        return if (helper.isCalculation) "${JavaHelper.CALCULATION}.${helper.called}" else helper.called
    }
}
