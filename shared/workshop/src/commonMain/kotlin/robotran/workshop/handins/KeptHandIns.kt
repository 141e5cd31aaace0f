package robotran.workshop.handins

import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.documents.FileStamp
import robotran.documents.StoreResult
import robotran.workshop.platform.KeyValueStore
import kotlin.io.encoding.Base64

/**
 * A file that was brought in, as it was.
 *
 * @property path its name, after the folders in which it lay, with `/` between.
 */
internal class BroughtFile(val path: String, val bytes: ByteArray) {
    val stamp: String by lazy { FileStamp.of(bytes).text }
}

/** Keeps the files and comments for one assignment on this device. */
internal class KeptHandIns(private val store: KeyValueStore, assignment: String) {
    private val name = "$PREFIX${FileStamp.of(assignment).text}"

    /** What [read] has found, or what was last written. */
    private var index = Index()

    /** The files in the order in which they were brought in; a file that cannot be read any more is left out. */
    suspend fun read(): List<BroughtFile> {
        index = indexIn(store.read(name))
        return index.files.mapNotNull { entry ->
            store.read(nameOf(entry))?.let(::decoded)?.let { BroughtFile(entry.path, it) }
        }
    }

    /** By the names of pupils. */
    val comments: Map<String, String> get() = index.comments

    /** Adds [files]; those that are there already are written once. */
    suspend fun add(files: List<BroughtFile>): StoreResult {
        for (file in files) {
            val entry = Entry(file.path, file.stamp)
            if (entry in index.files) continue
            val written = store.write(nameOf(entry), Base64.encode(file.bytes))
            if (written != StoreResult.Done) return written
            val next = index.copy(files = index.files + entry)
            val noted = write(next)
            if (noted != StoreResult.Done) return noted
        }
        return StoreResult.Done
    }

    suspend fun write(comments: Map<String, String>): StoreResult = write(index.copy(comments = comments))

    /** Removes all files and comments. */
    suspend fun clear() {
        val old = index
        index = Index()
        store.remove(name)
        old.files.map(::nameOf).distinct().forEach { store.remove(it) }
    }

    private suspend fun write(next: Index): StoreResult {
        val result = store.write(name, JSON.encodeToString(Index.serializer(), next))
        if (result == StoreResult.Done) index = next
        return result
    }

    private fun nameOf(entry: Entry) = "$name.${entry.stamp}"

    /** @property stamp of its content. */
    @Serializable
    private data class Entry(val path: String, val stamp: String)

    @Serializable
    private data class Index(val files: List<Entry> = emptyList(), val comments: Map<String, String> = emptyMap())

    internal companion object {
        private const val PREFIX = "hand-ins-"
        private val JSON = Json { ignoreUnknownKeys = true }

        /** More than any class has. */
        const val MAXIMUM_FILES = 400

        /** Bytes of all files together. */
        const val MAXIMUM_BYTES = 32_000_000L

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
