package robotran.workshop.handins

import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.assignments.collecting.CollectedFile
import robotran.documents.FileStamp
import robotran.documents.StoreResult
import robotran.workshop.platform.KeyValueStore
import kotlin.io.encoding.Base64

/**
 * Keeps the files that were brought in for one assignment, as they were, and the teacher's comments, on this device.
 *
 * @param assignment what tells it from others.
 */
internal class KeptHandIns(private val store: KeyValueStore, assignment: String) {
    private val name = "$PREFIX${FileStamp.of(assignment).text}"

    /** What [read] has found, or what was last written. */
    private var index = Index()
    private val writing = Mutex()

    /** Comments by hand-in. */
    val comments: Map<String, String> get() = index.comments

    /** What tells the hand-ins that the teacher has removed, see [MergedSubmissions.removed]. */
    val removed: Set<String> get() = index.removed

    /** The number of files. */
    val size: Int get() = index.files.size

    /** Bytes of all files together. */
    val bytes: Long get() = index.files.sumOf { it.size }

    /** The files in batches, in the order in which they were brought in. Leaves out what cannot be read any more. */
    suspend fun read(): List<List<CollectedFile>> {
        index = indexIn(store.read(name))
        return index.files.groupBy { it.batch }.entries.sortedBy { it.key }.map { (_, entries) ->
            entries.mapNotNull { entry ->
                store.read(nameOf(entry))?.let(::decoded)?.let { CollectedFile(entry.path, it) }
            }
        }.filter { it.isNotEmpty() }
    }

    /** Adds [files] as a batch. If one cannot be written, none is kept. */
    suspend fun add(files: List<CollectedFile>): StoreResult {
        val batch = (index.files.maxOfOrNull { it.batch } ?: 0) + 1
        val known = index.files.map { it.stamp }.toMutableSet()
        val entries = files.map { file ->
            val stamp = FileStamp.of(file.bytes).text
            val entry = Entry(file.path, stamp, batch, file.bytes.size.toLong())
            // The same content is written once.
            if (known.add(stamp)) {
                val written = store.write(nameOf(entry), Base64.encode(file.bytes))
                if (written != StoreResult.Done) return written
            }
            entry
        }
        return change { it.copy(files = it.files + entries) }
    }

    suspend fun write(comments: Map<String, String>): StoreResult = change { it.copy(comments = comments) }

    suspend fun writeRemoved(removed: Set<String>): StoreResult =
        if (removed == index.removed) StoreResult.Done else change { it.copy(removed = removed) }

    /** Whether the page was open when this was last written. */
    suspend fun wasOpen(): Boolean = indexIn(store.read(name)).isOpen

    /** Notes whether the page is open, to open it again after a reload; not if nothing is kept. */
    suspend fun writeOpen(isOpen: Boolean) {
        if (isOpen != index.isOpen && index.files.isNotEmpty()) change { it.copy(isOpen = isOpen) }
    }

    /** The result called [key]; null if there is none. */
    suspend fun result(key: String): String? = if (key in index.results) store.read(resultName(key)) else null

    /** Keeps [text] as the result called [key]; not if there is no room, since it can be found out anew. */
    suspend fun keepResult(key: String, text: String) {
        if (text.length > MAXIMUM_RESULT || index.files.isEmpty()) return
        if (store.write(resultName(key), text) != StoreResult.Done) return
        // Everything may have been removed meanwhile.
        if (index.files.isEmpty()) store.remove(resultName(key)) else change { it.copy(results = it.results + key) }
    }

    /** Removes all results. */
    suspend fun forgetResults() {
        val old = index.results
        change { it.copy(results = emptySet()) }
        old.forEach { store.remove(resultName(it)) }
    }

    /** Removes all files, results and comments. */
    suspend fun clear() {
        val old = index
        index = Index()
        store.remove(name)
        old.results.forEach { store.remove(resultName(it)) }
        old.files.map(::nameOf).distinct().forEach { store.remove(it) }
    }

    private suspend fun change(transform: (Index) -> Index): StoreResult = writing.withLock {
        val next = transform(index)
        val result = store.write(name, JSON.encodeToString(Index.serializer(), next))
        if (result == StoreResult.Done) index = next
        result
    }

    private fun resultName(key: String) = "$name.result.$key"

    private fun nameOf(entry: Entry) = "$name.${entry.stamp}"

    /**
     * @property stamp of its content.
     * @property batch the number of the batch with which it was brought in.
     */
    @Serializable
    private data class Entry(val path: String, val stamp: String, val batch: Int = 0, val size: Long = 0)

    @Serializable
    private data class Index(
        val files: List<Entry> = emptyList(),
        val comments: Map<String, String> = emptyMap(),
        val removed: Set<String> = emptySet(),
        val results: Set<String> = emptySet(),
        val isOpen: Boolean = false,
    )

    internal companion object {
        private const val PREFIX = "hand-ins-"
        private val JSON = Json { ignoreUnknownKeys = true }

        /** More than a class has, even in Java. */
        const val MAXIMUM_FILES = 1_000

        /** For all files together. */
        const val MAXIMUM_MEGABYTES = 32
        const val MAXIMUM_RESULT = 1_000_000
        const val MAXIMUM_BYTES = MAXIMUM_MEGABYTES * 1_000_000L

        private fun indexIn(text: String?): Index = try {
            if (text == null) Index() else JSON.decodeFromString(Index.serializer(), text)
        } catch (_: SerializationException) {
            Index()
        } catch (_: IllegalArgumentException) {
            Index()
        }

        private fun decoded(text: String): ByteArray? = try {
            Base64.decode(text)
        } catch (_: IllegalArgumentException) {
            null
        }
    }
}
