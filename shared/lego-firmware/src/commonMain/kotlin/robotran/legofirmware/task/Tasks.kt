package robotran.legofirmware.task

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.RcxImage

/** The tasks of the running program, which take turns: one instruction each. */
internal class Tasks {
    val all = List(FirmwareLimits.TASKS) { Task(it) }
    private var chunks: Map<ChunkId, LoadedChunk> = emptyMap()
    private var last = 0

    val anyAlive: Boolean get() = all.any { it.isAlive }

    /** Replaces the program; all tasks stop. */
    fun load(image: RcxImage) {
        stopAll()
        chunks = image.chunks.associate { it.id to LoadedChunk(it) }
        last = all.lastIndex
    }

    /** Starts a task at its beginning, also one that runs. Returns false if the program has no such task. */
    fun start(number: Int): Boolean {
        val chunk = chunks[ChunkId(ChunkKind.TASK, number)] ?: return false
        all[number].begin(Location(chunk, 0))
        return true
    }

    fun stop(number: Int) {
        all.getOrNull(number)?.stop()
    }

    fun stopAll() = all.forEach { it.stop() }

    fun sub(number: Int): LoadedChunk? = chunks[ChunkId(ChunkKind.SUB, number)]

    /** The task whose turn it is at [now]; null if all wait. The turn passes on only with [took]. */
    fun next(now: Long): Task? {
        for (distance in 1..all.size) {
            val task = all[(last + distance) % all.size]
            if (task.isReady(now)) return task
        }
        return null
    }

    fun took(task: Task) {
        last = task.number
    }

    /** The task that a debugger shows if it has no other choice: the next in turn, or the first that is alive. */
    fun focus(now: Long): Task? = next(now) ?: all.find { it.isAlive }
}
