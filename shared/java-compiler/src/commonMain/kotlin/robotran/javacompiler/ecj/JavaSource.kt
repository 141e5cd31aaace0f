package robotran.javacompiler.ecj

/**
 * One file of a program.
 *
 * @property path where it is, with slashes, such as `Square.java`; a public class in it must have the name of the file.
 * @property text what it holds, with any line ends and with or without a byte order mark.
 */
data class JavaSource(val path: String, val text: String)
