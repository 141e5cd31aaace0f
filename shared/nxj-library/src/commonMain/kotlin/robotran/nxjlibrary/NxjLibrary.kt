package robotran.nxjlibrary

/**
 * The classes that a brick with leJOS NXJ has besides those of its program: `java.lang`, `java.util`, `java.io` and
 * `lejos`.
 *
 * @property classFiles the class files, of version 50, by name with slashes, such as `java/lang/Object`.
 */
class NxjLibrary private constructor(val classFiles: Map<String, ByteArray>) {
    val classNames: Set<String> get() = classFiles.keys

    /** The class file of the class [name], with slashes; null if the library has none. */
    fun classFile(name: String): ByteArray? = classFiles[name]

    companion object {
        private const val CLASS = ".class"

        private var loaded: NxjLibrary? = null

        /**
         * Returns the library: at once on the JVM and Android. A browser fetches it for the first call, which throws if
         * that fails. All calls return the same one.
         */
        suspend fun load(): NxjLibrary = loaded ?: NxjLibrary(
            unpacked(packedClasses()).mapKeys { it.key.removeSuffix(CLASS) },
        ).also { loaded = it }
    }
}
