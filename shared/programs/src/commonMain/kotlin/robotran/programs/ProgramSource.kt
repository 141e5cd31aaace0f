package robotran.programs

/** A pupil's program as it lies in files. */
sealed interface ProgramSource {
    /** What the pupil knows the program by, usually the name of its first file. */
    val name: String

    /** A program in Robolang, which is always one file. */
    data class Robolang(override val name: String, val text: String) : ProgramSource

    /**
     * A leJOS program in Java.
     *
     * @property files its sources, one or more; the class to begin with is that of the first file, if it has a main
     * method, otherwise the first that has one.
     */
    data class Java(override val name: String, val files: List<SourceFile>) : ProgramSource

    /**
     * A leJOS program that was compiled elsewhere.
     *
     * @property classFiles what is in its class files, by the names they go by.
     * @property mainClass the class to begin with, with slashes; null for the first that has a main method.
     */
    class CompiledClasses(
        override val name: String,
        val classFiles: Map<String, ByteArray>,
        val mainClass: String? = null,
    ) : ProgramSource
}

/**
 * One file of a program.
 *
 * @property name its name, with or without folders, such as `Square.java`; a public class in it must be called like it.
 * @property text what is written in it, with any line ends.
 */
data class SourceFile(val name: String, val text: String)
