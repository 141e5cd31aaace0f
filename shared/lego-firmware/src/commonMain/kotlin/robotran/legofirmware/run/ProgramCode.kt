package robotran.legofirmware.run

import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage

/**
 * A program and which source it came from.
 *
 * @property lines without any line, the log and a debugger show none.
 */
internal class ProgramCode(val name: String, val image: RcxImage, val lines: LineTable)
