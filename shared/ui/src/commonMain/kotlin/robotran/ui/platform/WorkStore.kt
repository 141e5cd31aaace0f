package robotran.ui.platform

/** Texts with names that survive the end of the app, whichever way it ends. A text is replaced wholly or not at all. */
interface WorkStore {
    /** The names of all texts there are. */
    suspend fun names(): List<String>

    /** The text [name]; null if there is none, or none that is whole. */
    suspend fun read(name: String): String?

    /** Keeps [text] as [name], in place of what was there. */
    suspend fun write(name: String, text: String): Keeping

    /** Forgets [name]; nothing happens if there is none. */
    suspend fun remove(name: String)
}

/** What came of keeping a text. */
sealed interface Keeping {
    data object Kept : Keeping

    /** There is no room left. */
    data object Full : Keeping

    /** It could not be kept; [reason] is one sentence that says why. */
    data class Failed(val reason: String) : Keeping
}

/** Keeps texts as long as the app runs. */
class MemoryStore : WorkStore {
    private val texts = mutableMapOf<String, String>()

    override suspend fun names(): List<String> = texts.keys.toList()

    override suspend fun read(name: String): String? = texts[name]

    override suspend fun write(name: String, text: String): Keeping {
        texts[name] = text
        return Keeping.Kept
    }

    override suspend fun remove(name: String) {
        texts -= name
    }
}
