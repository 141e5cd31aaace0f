package robotran.simulation

/**
 * A line before which a program stops.
 *
 * @property line from 1.
 * @property sourceFile the file of the line; null for this line of any file. Ignored for a program of one file.
 */
data class Breakpoint(val line: Int, val sourceFile: String? = null)
