package robotran.legofirmware.run

import robotran.brick.program.CallFrame
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.SymbolKind
import robotran.legofirmware.task.Location
import robotran.legofirmware.task.Task
import robotran.legofirmware.task.TaskState

/** Shows tasks and variables of a program to a debugger. */
internal class Inspector(private val core: Core, private val program: ProgramCode) {
    private val names = VariableNames(program.image)

    fun threadView(task: Task, isCurrent: Boolean) = ThreadView(
        task.number,
        nameOf(ChunkId(ChunkKind.TASK, task.number)),
        activity = activityOf(task),
        callStack = callStack(task),
        isCurrent = isCurrent,
    )

    /** Null if it has ended. */
    fun activity(task: Task): ThreadActivity? = if (task.isAlive) activityOf(task) else null

    fun callStack(task: Task?): List<CallFrame> =
        listOfNotNull(task?.location, task?.returnTo).map { frameAt(it, program.lines) }

    /** The variables that [task] sees: its own, then those of all. */
    fun variables(task: Task?): List<VariableScope> {
        if (task == null) return emptyList()
        val locals = names.shown.filter { it >= FirmwareLimits.GLOBAL_VARIABLES }
        val globals = names.shown.filter { it < FirmwareLimits.GLOBAL_VARIABLES }
        val scopes = listOf(
            VariableScope(nameOf(ChunkId(ChunkKind.TASK, task.number)), views(locals, task)),
            VariableScope(program.name, views(globals, task)),
        )
        return scopes.filter { it.variables.isNotEmpty() }
    }

    private fun views(numbers: List<Int>, task: Task): List<VariableView> = numbers
        .filter { core.variables.exists(it, core.model.isSecond) }
        .map { VariableView(names.of(it), "${core.variables.get(it, task)}") }

    private fun activityOf(task: Task): ThreadActivity = when (task.state) {
        TaskState.WAITING -> ThreadActivity.SLEEPING
        else -> ThreadActivity.RUNNABLE
    }

    private fun frameAt(location: Location, lines: LineTable): CallFrame {
        val line = lines.lineOf(location.chunk.id, location.address)
        return CallFrame(nameOf(location.chunk.id), line?.line ?: 0, line?.file)
    }

    private fun nameOf(id: ChunkId): String = program.image.nameOf(id)?.takeIf { it.isNotEmpty() }
        ?: if (id.kind == ChunkKind.TASK) core.messages.task(id.number) else core.messages.sub(id.number)
}

/** Which variables of a program to show, and how they are called. */
private class VariableNames(image: RcxImage) {
    private val named: Map<Int, List<String>> = image.symbols.filter { it.kind == SymbolKind.VARIABLE }
        .groupBy({ it.number }, { it.name })
    private val used: Set<Int> = if (named.isEmpty()) VariablesUsed.of(image) else emptySet()

    /** Those with names; in a program without any, those that it uses. */
    val shown: List<Int> = (named.keys + used).sorted()

    /** A place that several variables use one after the other has all their names. */
    fun of(number: Int): String = named[number]?.distinct()?.joinToString(" / ") ?: "var[$number]"
}
