package robotran.legofirmware.run

import robotran.brick.program.CallFrame
import robotran.brick.program.DebugStatement
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.program.StatementWatch
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.task.Task

/** A run of a program on LEGO's firmware, for whoever wants to see more of it than its statements. */
interface LegoFirmwareRun : DebuggableRun {
    val firmware: FirmwareState
}

/** The run of [code], which it starts. A thread of it is a task with the same number. */
internal class FirmwareRun(private val machine: FirmwareMachine, code: ProgramCode) : LegoFirmwareRun {
    private val tasks = machine.core.tasks
    private val inspector = Inspector(machine.core, code)
    private var lastLine: CodeLine? = null

    /** The task whose statement the watch has let through or refused last; it may begin now. */
    private var passed: Task? = null

    override var watch: StatementWatch? = null

    override var statementsBegun = 0L
        private set

    init {
        machine.start(code)
    }

    override val firmware: FirmwareState get() = machine.state

    override val warnings: List<RuntimeWarning> get() = machine.warnings

    override val sourceLine: Int get() = currentLine?.line ?: 0

    override val sourceFile: String? get() = currentLine?.file

    override val callStack: List<CallFrame> get() = inspector.callStack(focus)

    override val variables: List<VariableScope> get() = inspector.variables(focus)

    override val threads: List<ThreadView>
        get() {
            val focus = focus
            return tasks.all.filter { it.isAlive }.map { inspector.threadView(it, isCurrent = it === focus) }
        }

    override fun activityOf(thread: Int): ThreadActivity? = tasks.all.getOrNull(thread)?.let { inspector.activity(it) }

    override fun variablesOf(thread: Int, frame: Int): List<VariableScope> =
        inspector.variables(tasks.all.getOrNull(thread)?.takeIf { it.isAlive })

    override val isBeforeStatement: Boolean get() = focus?.let { machine.beginningOf(it) } != null

    override fun isBeforeStatement(thread: Int): Boolean =
        tasks.all.getOrNull(thread)?.takeIf { it.isAlive }?.let { machine.beginningOf(it) } != null

    /** One instruction is a step; at most one is executed in a millisecond. */
    override fun resume(steps: Int): ProgramStatus {
        machine.tick()
        val task = machine.due()
        if (task != null && steps > 0) {
            if (pausesBefore(task)) return ProgramStatus.Paused(1)
            lastLine = machine.lineOf(task)
            machine.step(task)
        }
        return if (machine.isRunning) ProgramStatus.Running else ProgramStatus.Ended
    }

    private fun pausesBefore(task: Task): Boolean {
        val line = machine.beginningOf(task)
        if (line == null || task.isRepeating) return false
        val isPassed = passed === task
        passed = task
        val statement = DebugStatement(line.line, if (task.returnTo == null) 0 else 1, task.number, line.file)
        if (!isPassed && watch?.pausesBefore(statement) == true) return true
        passed = null
        statementsBegun++
        return false
    }

    private val focus: Task? get() = tasks.focus(machine.core.now)

    private val currentLine get() = focus?.let { machine.lineOf(it) } ?: lastLine
}
