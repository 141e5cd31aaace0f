package robotran.javacompiler.diagnose

/** The classes of the library and their packages, from their internal names. */
internal class LibraryNames(internalNames: Set<String>) {
    private val classes = internalNames.filterNot { '$' in it }.sorted()

    /** The names of all classes with their packages and points. */
    val qualifiedNames: List<String> = classes.map { it.replace('/', '.') }

    /** The names of all classes without their packages. */
    val simpleNames: List<String> = qualifiedNames.map { it.substringAfterLast('.') }

    /** The names of all packages with points. */
    val packages: List<String> = qualifiedNames.filter { '.' in it }.map { it.substringBeforeLast('.') }.distinct()

    /** The package with points of the class that is called so, null if there is none or it needs no import. */
    fun packageOf(simpleName: String): String? {
        val name = qualifiedNames.firstOrNull { it.substringAfterLast('.') == simpleName && '.' in it }
        return name?.substringBeforeLast('.')?.takeIf { it != "java.lang" }
    }
}
