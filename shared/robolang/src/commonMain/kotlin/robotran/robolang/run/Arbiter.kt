package robotran.robolang.run

/**
 * Decides which activity runs: the main program or a behaviour. Like leJOS's `Arbitrator`, it runs the action of the
 * last behaviour whose condition holds, once until another takes over: if the condition still holds when the action is
 * over, the robot waits for it to change. Only a later behaviour interrupts an action; an earlier one and the main
 * program wait until it is over. Unlike an action, the main program is not ended but resumed. An interrupted drive,
 * turn or pen movement is cut short.
 *
 * It evaluates the conditions before every statement and, while nothing else happens, every millisecond. Motors that
 * were started meanwhile stop in time, however long an evaluation takes.
 */
internal class Arbiter(private val machine: InterpreterState) {
    private val behaviours = machine.code.behaviours
    private val main = Activity(machine, machine.code.name, machine.code.main, machine.code.firstLine)
    private var current = NONE
    private var action: Activity? = null
    private var condition: Activity? = null
    private var lookedAt = 0
    private var lookTakesSteps = false
    private var decidedAt = NEVER

    /**
     * An evaluation that uses steps of the budget is valid for one statement; otherwise the robot would do nothing but
     * evaluate conditions.
     */
    private var isStatementDue = false

    private val isWatching: Boolean get() = behaviours.isNotEmpty() && machine.isWatching

    /** The activity to run, unless it waits; null if the main program waits for a condition to change. */
    private val running: Activity? get() = action ?: main.takeIf { current == NONE }

    /** The running and waiting activities, innermost first: a condition, an action, the main program. */
    val activities: List<Activity> get() = listOfNotNull(condition, action, main)

    val foremost: Activity get() = condition ?: action ?: main

    /** Whether the run is over, whatever happens. */
    val isOver: Boolean get() = behaviours.isEmpty() && main.isOver

    /** When the conditions are evaluated next if nothing happens before. */
    val nextLook: Long get() = machine.robot.milliseconds + RobotConstants.LOOKING_MILLISECONDS

    /** When the waiting [activity], the next to run, resumes. */
    fun wakesAt(activity: Activity): Long {
        val looksAgain = isWatching && condition == null && behaviours.lastIndex > current
        val other = running?.takeIf { it.isWaiting } ?: activity
        return minOf(activity.waitUntil, other.waitUntil, if (looksAgain) nextLook else Long.MAX_VALUE)
    }

    /** The next activity; null if there is none until a condition changes. */
    fun choose(): Activity? {
        if (!isWatching) return main.takeUnless { it.isOver }
        if (action?.isOver == true) endAction()
        if (running?.isInsideStatement == true) return running
        while (decidedAt != machine.robot.milliseconds && !isStatementDue) {
            val looking = condition ?: look(behaviours.lastIndex)
            when {
                looking == null -> decide(NONE)
                !looking.isOver -> return looking
                looking.pop() != 0 -> decide(lookedAt)
                else -> if (look(lookedAt - 1) == null) decide(NONE)
            }
        }
        return condition ?: running?.takeUnless { it.isOver }
    }

    /** Marks the conditions as evaluated until the next statement. */
    fun statementBegins() {
        if (condition != null) {
            lookTakesSteps = true
        } else {
            decidedAt = NEVER
            isStatementDue = false
        }
    }

    /** The call depth of [activity], including behaviours. */
    fun depthOf(activity: Activity): Int =
        activity.depth + activities.dropWhile { it !== activity }.drop(1).sumOf { it.depth + 1 }

    /** Begins to evaluate a condition; null if none of the remaining behaviours can interrupt the running action. */
    private fun look(behaviour: Int): Activity? {
        lookedAt = behaviour
        val firstToLookAt = if (action != null) current + 1 else 0
        val code = behaviours.getOrNull(behaviour).takeIf { behaviour >= firstToLookAt }
        condition = code?.let { Activity(machine, BEHAVIOUR_NAME, it.condition, it.line) }
        return condition
    }

    private fun decide(behaviour: Int) {
        condition = null
        decidedAt = machine.robot.milliseconds
        if (behaviour == NONE) {
            if (action == null) current = NONE
        } else if (behaviour != current) {
            (action ?: main).cutShort()
            current = behaviour
            action = behaviours[behaviour].let { Activity(machine, BEHAVIOUR_NAME, it.action, it.line) }
        }
        isStatementDue = lookTakesSteps && running?.statement != null && running?.isWaiting == false
        lookTakesSteps = false
    }

    private fun endAction() {
        action = null
        decidedAt = NEVER
        isStatementDue = false
    }

    private companion object {
        const val NONE = -1
        const val NEVER = -1L

        /** The name of a behaviour in the call stack: its keyword. */
        const val BEHAVIOUR_NAME = "whenever"
    }
}
