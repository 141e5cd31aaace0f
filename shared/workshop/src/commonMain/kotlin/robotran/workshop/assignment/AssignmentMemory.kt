package robotran.workshop.assignment

import kotlinx.coroutines.CoroutineScope
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.service.SerialWriteQueue

/** What this device remembers of pupils' work: the name, what was handed in under which name, and the folded task. */
internal class AssignmentMemory(private val store: KeyValueStore, scope: CoroutineScope) {
    private val writes = SerialWriteQueue(scope)
    private var kept = Kept()

    /** The name entered last; empty before that. */
    val name: String get() = kept.name

    /** The name under which the assignment [id] was handed in; null if it was not. */
    fun handedInAs(id: String): String? = kept.handedIn[id]

    /** Whether the card of the task is folded; null if that was never chosen. */
    val isTaskFolded: Boolean? get() = kept.taskFolded

    suspend fun load() {
        val text = store.read(NAME) ?: return
        kept = try {
            JSON.decodeFromString(Kept.serializer(), text)
        } catch (_: SerializationException) {
            Kept()
        } catch (_: IllegalArgumentException) {
            Kept()
        }
    }

    /** The assignment [id] was handed in under [name]. */
    fun handedIn(id: String, name: String) {
        // The oldest go first.
        val others = (kept.handedIn - id).entries.toList().takeLast(MAX_KEPT - 1).associate { it.key to it.value }
        keep(kept.copy(name = name, handedIn = others + (id to name)))
    }

    fun fold(isFolded: Boolean) = keep(kept.copy(taskFolded = isFolded))

    private fun keep(changed: Kept) {
        kept = changed
        writes.add { store.write(NAME, JSON.encodeToString(Kept.serializer(), changed)) }
    }

    suspend fun saveNow() = writes.finish()

    @Serializable
    private data class Kept(
        val name: String = "",
        val handedIn: Map<String, String> = emptyMap(),
        val taskFolded: Boolean? = null,
    )

    private companion object {
        const val NAME = "hand-ins"
        const val MAX_KEPT = 200
        val JSON = Json { ignoreUnknownKeys = true }
    }
}
