package robotran.learning

/** Texts by name, each of which is read from its path in [paths] only when it is asked for. */
internal class LazyTexts(private val paths: Map<String, String>, private val read: (path: String) -> String) :
    AbstractMap<String, String>() {
    override val keys: Set<String> get() = paths.keys

    override val entries: Set<Map.Entry<String, String>> = paths.map { (name, path) ->
        object : Map.Entry<String, String> {
            override val key = name
            override val value: String get() = read(path)
        }
    }.toSet()

    override fun containsKey(key: String): Boolean = key in paths

    override fun get(key: String): String? = paths[key]?.let(read)
}
