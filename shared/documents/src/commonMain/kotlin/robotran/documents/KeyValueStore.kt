package robotran.documents

/**
 * Where the app keeps texts by name: the pupil's work, settings, what was learned. Each platform has one; what is in it
 * belongs to this device alone.
 *
 * Names have at most [MAXIMUM_NAME] characters, all of them of `a`-`z`, `0`-`9`, `-` and `.`, and begin with a letter.
 * A store may lose a text that it is just writing when the app is killed, or leave a piece of it; all others stay as
 * they are. [ProjectRepository] makes sure that nothing is lost by that.
 */
interface KeyValueStore {
    /** The names of all texts, in no order; empty where the store cannot be read. */
    suspend fun names(): List<String>

    /** The text [name]; null if there is none, or none that can be read. */
    suspend fun read(name: String): String?

    /** Writes [text] in place of what was there. Once this says [StoreResult.Done], it survives a crash of the app. */
    suspend fun write(name: String, text: String): StoreResult

    /** Takes the text away; done as well if there was none. */
    suspend fun remove(name: String): StoreResult

    /**
     * Claims [name] for this window until the claim is released or the window is gone, however it ends; null if another
     * window has it. A claim is about the name alone, there may be a text of that name or not.
     */
    suspend fun claim(name: String): ProjectLock?

    companion object {
        const val MAXIMUM_NAME = 60
    }
}

/** A name that nobody else has, see [KeyValueStore.claim]. */
fun interface ProjectLock {
    fun release()
}

/** What came of writing to a [KeyValueStore] or to a file. */
sealed interface StoreResult {
    data object Done : StoreResult

    /** There is no room left on this device, or none for this app. */
    data object Full : StoreResult

    /**
     * It cannot be written for another reason, such as a folder that is read-only; [reason] is what the platform says.
     */
    data class Failed(val reason: String) : StoreResult
}
