package robotran.microbitlink.link

import robotran.microbitlink.BoardDescription
import robotran.microbitlink.BoardError
import robotran.microbitlink.BoardResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.dap.DapAnswer
import robotran.microbitlink.dap.DapCommand
import robotran.microbitlink.dap.DapLine
import robotran.microbitlink.u8

/** Asks a board what it is. */
internal suspend fun meetBoard(line: DapLine): BoardResult<BoardDescription> {
    repeat(TRIES) {
        val answer = line.command(DapCommand.UNIQUE_ID)
        if (answer is DapAnswer.Gone) return BoardResult.Failure(BoardError.OutOfReach)
        if (answer is DapAnswer.Good) {
            val serialNumber = textOf(answer.bytes)
            val board = serialNumber.take(BOARD_DIGITS).toIntOrNull(HEXADECIMAL)?.let(MicrobitBoard::ofId)
                ?: return BoardResult.Failure(BoardError.NotAMicrobit)
            return BoardResult.Success(BoardDescription(board, serialNumber, daplink(line)))
        }
    }
    return BoardResult.Failure(BoardError.BadConnection)
}

/** The version of DAPLink; null if it does not tell. */
private suspend fun daplink(line: DapLine): Int? {
    val answer = line.command(DapCommand.INFO, DapCommand.PRODUCT_VERSION) as? DapAnswer.Good ?: return null
    return textOf(answer.bytes).takeIf { it.length == VERSION_DIGITS }?.toIntOrNull()
}

/** A text behind its length. */
private fun textOf(bytes: ByteArray): String {
    val length = minOf(bytes.u8(0), bytes.size - 1)
    return bytes.decodeToString(1, 1 + length).trimEnd('\u0000')
}

private const val TRIES = 3
private const val BOARD_DIGITS = 4
private const val VERSION_DIGITS = 4
private const val HEXADECIMAL = 16
