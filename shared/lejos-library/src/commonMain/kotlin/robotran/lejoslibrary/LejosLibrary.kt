package robotran.lejoslibrary

import kotlin.io.encoding.Base64

/** The classes that a leJOS brick has besides those of its program: `java.lang`, `java.util`, `java.io` and `josx`. */
object LejosLibrary {
    /** The names of all classes, with slashes, such as `java/lang/Object`. */
    val classNames: Set<String> = libraryClasses.keys.map { it.removeSuffix(CLASS) }.toSet()

    /** The class file, of version 45.3, of the class [name], with slashes; null if the library has none. */
    fun classFile(name: String): ByteArray? = libraryClasses[name + CLASS]?.let(Base64::decode)

    /**
     * The Java of the class [name], with slashes, whose comments are its help; null if the library has none. Inner
     * classes are in their outer class's.
     */
    fun source(name: String): String? = librarySources["${name.substringBefore('$')}.java"]

    private const val CLASS = ".class"
}
