package robotran.legofirmware.run

import robotran.brick.program.CallFrame
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.task.LoadedChunk
import robotran.legofirmware.task.Task

/** Shows tasks and variables of a program to a debugger. */
internal class Inspector(private val core: Core, private val program: ProgramCode) {
    private val names = VariableNames(program)

    fun threadView(task: Task, isCurrent: Boolean) = ThreadView(
        task.number,
        nameOf(ChunkId(ChunkKind.TASK, task.number)),
        activity = activityOf(task),
        callStack = callStack(task),
        isCurrent = isCurrent,
    )

    /** Null if it has ended. */
    fun activity(task: Task): ThreadActivity? = if (task.isAlive) activityOf(task) else null

    fun callStack(task: Task?): List<CallFrame> = listOfNotNull(
        task?.placeAt(core.now)?.let { frameAt(it.chunk, it.address) },
        task?.returnTo?.let { frameAt(it.chunk, it.address - 1) },
    )

    /** The variables that [task] sees: its own, then those of all. */
    fun variables(task: Task?): List<VariableScope> {
        if (task == null) return emptyList()
        val open =
            listOfNotNull(ChunkId(ChunkKind.TASK, task.number), task.location?.chunk?.id, task.returnTo?.chunk?.id)
        val locals = names.own(open.toSet())
        val scopes = listOf(
            VariableScope(nameOf(ChunkId(ChunkKind.TASK, task.number)), views(locals, task)),
            VariableScope(program.name, views(names.shared, task)),
        )
        return scopes.filter { it.variables.isNotEmpty() }
    }

    private fun views(named: Map<Int, String>, task: Task): List<VariableView> = named
        .filterKeys { core.variables.exists(it, core.model.isSecond) }
        .map { (number, name) -> VariableView(name, "${core.variables.get(number, task)}") }

    private fun activityOf(task: Task): ThreadActivity =
        if (task.isWaiting(core.now)) ThreadActivity.SLEEPING else ThreadActivity.RUNNABLE

    /** @param address of any byte of the instruction: before the place of a return is the call. */
    private fun frameAt(chunk: LoadedChunk, address: Int): CallFrame {
        val line = program.lines.lineOf(chunk.id, address)
        return CallFrame(nameOf(chunk.id), line?.line ?: 0, line?.file)
    }

    private fun nameOf(id: ChunkId): String = program.image.nameOf(id)?.takeIf { it.isNotEmpty() }
        ?: if (id.kind == ChunkKind.TASK) core.messages.task(id.number) else core.messages.sub(id.number)
}
