package robotran.robolang.run

import robotran.brick.program.CallFrame
import robotran.brick.program.DebugStatement
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.brick.program.StatementWatch
import robotran.brick.program.VariableScope
import robotran.robolang.messages.RobolangRunMessages
import robotran.robolang.robot.Durations

/**
 * One run of a Robolang program. A step is a statement or a loop's check for another round, so even an empty loop uses
 * its budget. The whole state is on the stacks of its activities, so the run can stop before any statement.
 */
internal class RobolangRun(code: Code, robot: RobotDevice, durations: Durations, messages: RobolangRunMessages) :
    DebuggableRun {
    private val machine = InterpreterState(code, robot, durations, messages)
    private val arbiter = Arbiter(machine)
    private var isPassed = false

    init {
        machine.activities = { arbiter.activities }
    }

    /** The running activity. */
    private var active = arbiter.foremost

    override var watch: StatementWatch? = null

    override var statementsBegun = 0L
        private set

    override val sourceLine: Int get() = machine.setUpLine ?: arbiter.foremost.sourceLine

    override val isBeforeStatement: Boolean get() = !arbiter.foremost.isWaiting

    override val callStack: List<CallFrame>
        get() = arbiter.activities.flatMap { it.frames() }.map { CallFrame(it.name, it.line) }

    override val variables: List<VariableScope> get() = variableScopes(arbiter.activities, 0)

    override fun variablesOf(thread: Int, frame: Int): List<VariableScope> = if (thread == DebuggableRun.FIRST_THREAD &&
        frame >= 0
    ) {
        variableScopes(arbiter.activities, frame)
    } else {
        emptyList()
    }

    override fun resume(steps: Int): ProgramStatus = try {
        proceed(steps)
    } catch (failure: RunFailure) {
        ProgramStatus.Failed(ProgramFailure(failure.message, active.currentLine))
    }

    private fun proceed(steps: Int): ProgramStatus {
        var budget = steps
        while (!machine.isHalted) {
            val activity =
                arbiter.choose()
                    ?: return if (arbiter.isOver) ProgramStatus.Ended else ProgramStatus.Waiting(arbiter.nextLook)
            val statement = activity.statement
            when {
                activity.isWaiting -> return ProgramStatus.Waiting(arbiter.wakesAt(activity))

                statement == null -> {
                    active = activity
                    activity.proceed()
                }

                budget <= 0 -> return ProgramStatus.Running
                isStoppedBefore(statement, activity) -> return ProgramStatus.Paused(budget)

                else -> {
                    budget--
                    begin(statement, activity)
                }
            }
        }
        return ProgramStatus.Ended
    }

    private fun begin(statement: Boundary.Statement, activity: Activity) {
        isPassed = false
        statementsBegun++
        arbiter.statementBegins()
        active = activity
        activity.begin(statement)
        activity.proceed()
    }

    private fun isStoppedBefore(statement: Boundary.Statement, activity: Activity): Boolean {
        val watch = watch
        if (watch == null || isPassed) return false
        isPassed = true
        return watch.pausesBefore(DebugStatement(statement.line, arbiter.depthOf(activity)))
    }
}
