package robotran.javacompiler.ecj

/**
 * One file of a program.
 *
 * @property path its path, with slashes, such as `Square.java`; a public class in it must have the name of the file.
 * @property text its content, with any line breaks and with or without a byte order mark.
 */
data class JavaSource(val path: String, val text: String)
