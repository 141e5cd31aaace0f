package robotran.documents

/**
 * A store in memory: for tests, and for devices that do not permit storage.
 *
 * @param texts the initial content.
 */
class MemoryKeyValueStore(texts: Map<String, String> = emptyMap()) : KeyValueStore {
    private val kept = texts.toMutableMap()
    private val claimed = mutableSetOf<String>()

    val texts: Map<String, String> get() = kept.toMap()

    override suspend fun names(): List<String> = kept.keys.toList()

    override suspend fun read(name: String): String? = kept[name]

    override suspend fun write(name: String, text: String): StoreResult {
        kept[name] = text
        return StoreResult.Done
    }

    override suspend fun remove(name: String): StoreResult {
        kept.remove(name)
        return StoreResult.Done
    }

    override suspend fun claim(name: String): ProjectLock? = if (claimed.add(name)) {
        ProjectLock {
            claimed.remove(name)
        }
    } else {
        null
    }
}
