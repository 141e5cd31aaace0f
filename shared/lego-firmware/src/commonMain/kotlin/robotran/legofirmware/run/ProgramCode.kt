package robotran.legofirmware.run

import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.VariableTable

/**
 * A program and which source it came from.
 *
 * @property lines without any line, the log and a debugger show none.
 * @property variables null if only the image says something about them.
 */
internal class ProgramCode(
    val name: String,
    val image: RcxImage,
    val lines: LineTable,
    val variables: VariableTable? = null,
) {
    /** How the source calls the variables that are in the brick only once, by their number. */
    val variableNames: Map<Int, String> by lazy { VariableNames(this).single }
}
