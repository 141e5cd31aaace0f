package robotran.robolang.run

/**
 * Decides which activity goes on: the main program or a behaviour. As leJOS's `Arbitrator`, it does the action of the
 * latest behaviour whose condition holds, once for as long as no other takes its place: when the action is over and the
 * condition still holds, the robot waits for it to change. An action is ended only by a later behaviour; an earlier one
 * and the main program wait until it is over. The main program, unlike an action, is not ended but goes on where it
 * was. A drive, turn or move of the pen that is interrupted is cut short.
 *
 * It looks at the conditions before every statement and, while nothing else happens, once every millisecond. What has
 * begun to drive meanwhile stops in time, however long a look takes.
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

    /** A look that takes steps of the budget holds for one statement, or the robot would do nothing but look. */
    private var isStatementDue = false

    private val isWatching: Boolean get() = behaviours.isNotEmpty() && machine.isWatching

    /** What does something, unless it waits; null if the main program has to wait for a condition to change. */
    private val running: Activity? get() = action ?: main.takeIf { current == NONE }

    /** What runs or waits now, the innermost first: a condition, an action, the main program. */
    val activities: List<Activity> get() = listOfNotNull(condition, action, main)

    val foremost: Activity get() = condition ?: action ?: main

    /** Whether nothing is left to be done, whatever happens. */
    val isOver: Boolean get() = behaviours.isEmpty() && main.isOver

    /** When the conditions are looked at again if nothing happens before. */
    val nextLook: Long get() = machine.rom.milliseconds + RobotConstants.LOOKING_MILLISECONDS

    /** Until when nothing is to be done while [activity], which is to go on, waits. */
    fun wakesAt(activity: Activity): Long {
        val looksAgain = isWatching && condition == null && behaviours.lastIndex > current
        val other = running?.takeIf { it.isWaiting } ?: activity
        return minOf(activity.waitUntil, other.waitUntil, if (looksAgain) nextLook else Long.MAX_VALUE)
    }

    /** The activity to go on with now, null if there is none until a condition changes. */
    fun choose(): Activity? {
        if (!isWatching) return main.takeUnless { it.isOver }
        if (action?.isOver == true) endAction()
        if (running?.isInsideStatement == true) return running
        while (decidedAt != machine.rom.milliseconds && !isStatementDue) {
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

    /** The conditions count as looked at until the next statement. */
    fun statementBegins() {
        if (condition != null) {
            lookTakesSteps = true
        } else {
            decidedAt = NEVER
            isStatementDue = false
        }
    }

    /** How many routines and behaviours [activity] is inside of. */
    fun depthOf(activity: Activity): Int =
        activity.depth + activities.dropWhile { it !== activity }.drop(1).sumOf { it.depth + 1 }

    /** Begins to look at a condition; null if only those are left that cannot take the place of the running action. */
    private fun look(behaviour: Int): Activity? {
        lookedAt = behaviour
        val firstToLookAt = if (action != null) current + 1 else 0
        val code = behaviours.getOrNull(behaviour).takeIf { behaviour >= firstToLookAt }
        condition = code?.let { Activity(machine, BEHAVIOUR_NAME, it.condition, it.line) }
        return condition
    }

    private fun decide(behaviour: Int) {
        condition = null
        decidedAt = machine.rom.milliseconds
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

        /** What a behaviour is called in the call stack: the word it begins with. */
        const val BEHAVIOUR_NAME = "whenever"
    }
}
