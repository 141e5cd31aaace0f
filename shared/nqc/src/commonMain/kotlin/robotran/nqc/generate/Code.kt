package robotran.nqc.generate

import robotran.language.source.SourceRange

/**
 * The code of a task or subroutine.
 *
 * @property lines in the order of their addresses.
 */
internal class Code(val bytes: ByteArray, val lines: List<NqcCodeLine>)

/**
 * Code from [address] to the next line comes from a statement.
 *
 * @property address in bytes from the beginning of the task or subroutine.
 * @property range the statement's place in the source; of a function of the API, the place of its call.
 */
data class NqcCodeLine(val address: Int, val range: SourceRange)
