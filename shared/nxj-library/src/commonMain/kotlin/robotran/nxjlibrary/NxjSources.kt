package robotran.nxjlibrary

/** The Java of [NxjLibrary], whose comments are its help. */
class NxjSources private constructor(private val sources: Map<String, ByteArray>) {
    /** The outer classes, with slashes. */
    val classNames: Set<String> by lazy { sources.keys.map { it.removeSuffix(".java") }.toSet() }

    /**
     * The Java of the class [name], with slashes; null if the library has none. Inner classes are in their outer
     * class's.
     */
    fun source(name: String): String? = sources["${name.substringBefore('$')}.java"]?.decodeToString()

    companion object {
        private var loaded: NxjSources? = null

        /** What [load] has returned; null before. */
        val known: NxjSources? get() = loaded

        /** Returns the sources, as [NxjLibrary.load] returns the library. */
        suspend fun load(): NxjSources = loaded ?: NxjSources(unpacked(packedSources())).also { loaded = it }
    }
}
