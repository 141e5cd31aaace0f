package robotran.documents

/**
 * The app's persistent store of texts by name: projects, settings, learning progress. Each platform has one, local to
 * the device.
 *
 * Names have at most [MAXIMUM_NAME] characters, only `a`-`z`, `0`-`9`, `-` and `.`, and begin with a letter. If the app
 * is killed during a write, that text may be lost or truncated; all others stay intact. [ProjectRepository] protects
 * projects from this.
 */
interface KeyValueStore {
    /** Whether the store answers. Where it does not, reading finds nothing, and writing is [StoreResult.NoAnswer]. */
    val isAnswering: Boolean get() = true

    /** The names of all texts, in no order; empty if the store cannot be read. */
    suspend fun names(): List<String>

    /** The text [name]; null if it is missing or unreadable. */
    suspend fun read(name: String): String?

    /** Writes [text] and replaces the old one. After [StoreResult.Done], it survives a crash of the app. */
    suspend fun write(name: String, text: String): StoreResult

    /** Removes the text; succeeds also if there was none. */
    suspend fun remove(name: String): StoreResult

    /**
     * Locks [name] for this window until the lock is released or the window is gone for any reason; null if another
     * window holds the lock. The lock does not depend on a text of that name.
     */
    suspend fun claim(name: String): ProjectLock?

    companion object {
        const val MAXIMUM_NAME = 60
    }
}

/** An exclusive lock on a name, see [KeyValueStore.claim]. */
fun interface ProjectLock {
    fun release()
}

/** The result of writing to a [KeyValueStore] or to a file. */
sealed interface StoreResult {
    data object Done : StoreResult

    /** The device or the app has no free storage left. */
    data object Full : StoreResult

    /** The store says nothing; what was written may be lost. */
    data object NoAnswer : StoreResult

    /** The write failed for another reason, such as a read-only folder; [reason] is the platform's message. */
    data class Failed(val reason: String) : StoreResult
}
