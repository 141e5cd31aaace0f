package robotran.javacompiler.diagnose

/** The classes and packages of the library, from their internal names. */
internal class LibraryNames(internalNames: Set<String>) {
    private val classes = internalNames.filterNot { '$' in it }.sorted()

    /** The names of all classes with their packages, separated by dots. */
    val qualifiedNames: List<String> = classes.map { it.replace('/', '.') }

    /** The names of all classes without their packages. */
    val simpleNames: List<String> = qualifiedNames.map { it.substringAfterLast('.') }

    /** The names of all packages, separated by dots. */
    val packages: List<String> = qualifiedNames.filter { '.' in it }.map { it.substringBeforeLast('.') }.distinct()

    /** Returns the package of the class [simpleName], with dots; null if there is none or it needs no import. */
    fun packageOf(simpleName: String): String? {
        val name = qualifiedNames.firstOrNull { it.substringAfterLast('.') == simpleName && '.' in it }
        return name?.substringBeforeLast('.')?.takeIf { it != "java.lang" }
    }
}
