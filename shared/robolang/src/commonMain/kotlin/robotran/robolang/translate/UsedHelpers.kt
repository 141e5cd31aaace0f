package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget
import robotran.robolang.template.fillIn

/** Collects the helpers that a translation uses; only those are written. */
internal class UsedHelpers(private val robot: RobotTarget, val isReacting: Boolean) {
    private val used = mutableSetOf<JavaHelper>()

    /** What the motors of the robot are called. */
    val motors = JavaMotors(robot)

    /** For constants. */
    val durations = Durations(robot)

    private val values: Map<String, String> by lazy {
        val waiting = JavaTemplates.of("WAITING", BrickKind.NXT, isReacting)
        figuresOf(robot) + mapOf("THROWS" to throwsClause(isReacting), "WAITING" to waiting)
    }

    /** The used helpers, in order of declaration. */
    val all: List<JavaHelper> get() = JavaHelper.entries.filter { it in used }

    init {
        if (isReacting) listOf(JavaHelper.PAUSE, JavaHelper.PAUSE_IN_CONTROL).forEach(::use)
    }

    /** The Java of [helper] for the robot. */
    fun textOf(helper: JavaHelper): String {
        val text = JavaTemplates.of(helper.name, robot.kind, isReacting).fillIn(values)
        return when {
            robot.kind == BrickKind.RCX -> motors.of(text)
            helper == JavaHelper.PILOT -> motors.ofPilot(text)
            helper == JavaHelper.PEN_DOWN || helper == JavaHelper.PEN_UP -> motors.ofPen(text, isReacting)
            else -> text
        }
    }

    /** The Java that waits for so many milliseconds. */
    fun sleep(milliseconds: Int): String = if (isReacting) "pause($milliseconds);" else "Thread.sleep($milliseconds);"

    /** Marks [helper] and its dependencies as used; returns the name to call it by. */
    fun use(helper: JavaHelper): String {
        if (used.add(helper)) helper.needsOn(robot.kind, isReacting).forEach(::use)
        return if (helper.isCalculation) "${JavaHelper.CALCULATION}.${helper.called}" else helper.called
    }
}
