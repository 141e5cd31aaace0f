package robotran.java.diagnose

/** The classes of the library and their packages, from their internal names. */
internal class LibraryNames(internalNames: Set<String>) {
    private val classes = internalNames.filterNot { '$' in it }.sorted()

    /** The names of all classes without their packages. */
    val simpleNames: List<String> = classes.map { it.substringAfterLast('/') }

    /** The package with dots of the class that is called so, null if there is none or it needs no import. */
    fun packageOf(simpleName: String): String? =
        classes.firstOrNull { it.substringAfterLast('/') == simpleName && '/' in it }
            ?.substringBeforeLast('/')?.replace('/', '.')?.takeIf { it != "java.lang" }
}
