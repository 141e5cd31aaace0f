package robotran.nxjlibrary

/**
 * The classes that a brick with leJOS NXJ has besides those of its program: `java.lang`, `java.util`, `java.io` and
 * `lejos`.
 *
 * @property classFiles the class files, of version 50, by name with slashes, such as `java/lang/Object`.
 */
class NxjLibrary private constructor(val classFiles: Map<String, ByteArray>) {
    /**
     * The same class files without what leJOS NXJ lacks: compilers do not find [NxjDifferences] in them. For compiling
     * only; programs run with [classFiles].
     */
    val classFilesOfBrick: Map<String, ByteArray> by lazy {
        val missing = NxjDifferences.all.groupBy({ it.owner }, { it.member })
        classFiles + missing.mapValues { (owner, members) ->
            withHiddenMembers(classFiles.getValue(owner), members.toSet())
        }
    }

    val classNames: Set<String> get() = classFiles.keys

    /** The class file of the class [name], with slashes; null if the library has none. */
    fun classFile(name: String): ByteArray? = classFiles[name]

    /**
     * What leJOS NXJ lacks that a program means by [member], as in [NxjDifference.member], of the class [owner] or a
     * superclass; null if it has that.
     */
    fun differenceFor(owner: String, member: String): NxjDifference? {
        var type: String? = owner
        while (type != null) {
            val found = NxjDifference(type, member)
            if (found in differences) return found
            type = classFiles[type]?.let(::superclassOf)
        }
        return null
    }

    companion object {
        private const val CLASS = ".class"

        private val differences = NxjDifferences.all.toSet()

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
