package robotran.tower.port

import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.getAndUpdate
import kotlinx.coroutines.flow.update

/**
 * What a tower's reading loop has received and nobody has taken yet, for [TowerPort.receive]. The loop may run on
 * another thread.
 */
class ReceivedBytes {
    private val waiting = MutableStateFlow(Waiting(emptyList(), isOver = false))

    /** Adds [bytes]. If nobody takes them, the oldest are lost. */
    fun add(bytes: ByteArray) {
        if (bytes.isNotEmpty()) waiting.update { Waiting((it.parts + listOf(bytes)).takeLast(MAX_PARTS), it.isOver) }
    }

    /** Says that nothing more will come. */
    fun end() = waiting.update { Waiting(it.parts, isOver = true) }

    /** See [TowerPort.receive]. */
    suspend fun take(): ByteArray? {
        waiting.first { it.parts.isNotEmpty() || it.isOver }
        val taken = waiting.getAndUpdate { Waiting(emptyList(), it.isOver) }.parts
        if (taken.isEmpty()) return null
        val joined = ByteArray(taken.sumOf { it.size })
        var place = 0
        for (part in taken) {
            part.copyInto(joined, place)
            place += part.size
        }
        return joined
    }

    private class Waiting(val parts: List<ByteArray>, val isOver: Boolean)

    private companion object {
        /** Several seconds of the line, if each part has one byte. */
        const val MAX_PARTS = 4_096
    }
}
