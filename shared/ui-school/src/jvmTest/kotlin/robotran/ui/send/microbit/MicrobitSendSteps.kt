package robotran.ui.send.microbit

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.SendProgress
import robotran.microbitlink.dap.PluggedBoard
import robotran.microbitlink.serial.BoardConsole
import robotran.microbitlink.serial.PythonError
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.FoundBoard
import robotran.workshop.state.FoundMicroPython
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.MicrobitTransfer
import robotran.workshop.state.ProgramSize
import robotran.workshop.state.ShownNumber

internal val MICROPYTHON =
    FoundMicroPython("microbit-program.hex", mapOf(MicrobitBoard.V1 to "1.1.1", MicrobitBoard.V2 to "2.1.2"))
internal val SIZE = ProgramSize(2_380, 20_150)
internal val BOARD = FoundBoard(MicrobitBoard.V2)
internal val BOARDS = listOf(PluggedBoard("1", "BBC micro:bit"), PluggedBoard("2", "BBC micro:bit"))

private val ERRORS = listOf(
    BoardError.OutOfReach,
    BoardError.Taken,
    BoardError.NotAllowed,
    BoardError.InterfaceTooOld,
    BoardError.NotAMicrobit,
    BoardError.BadFile(ImageError.OtherBoard(MicrobitBoard.V1)),
    BoardError.BrokenOff,
    BoardError.BadConnection,
    BoardError.NoPython,
    BoardError.NoRoom,
    BoardError.NotAsSent,
)

internal val PRINTED = BoardConsole(List(40) { "distance ${it * 7}" }, unfinished = "dist")

/** One step of each kind, and each error, by a name for its picture. */
internal val MICROBIT_STEPS: Map<String, MicrobitSendState> = buildMap {
    fun put(
        name: String,
        step: MicrobitSendStep,
        microPython: FoundMicroPython? = MICROPYTHON,
        board: FoundBoard? = BOARD,
    ) = put(name, MicrobitSendState("square.robo", step, SIZE, microPython, board))

    fun choosing(problem: ChoosingProblem?, vararg transfers: MicrobitTransfer) =
        MicrobitSendStep.Choosing(transfers.toSet(), problem)
    put("building", MicrobitSendStep.Building)
    val mistake = Diagnostic(Severity.ERROR, "square.robo", SourceRange(12, 5, 9), "A micro:bit has no battery sensor.")
    put("mistake", MicrobitSendStep.HasErrors(mistake))
    put("compiler-failed", MicrobitSendStep.CompilerFailed)
    put("first", choosing(null), microPython = null)
    put("first-usb", choosing(null, MicrobitTransfer.USB), microPython = null)
    put("choose-save", choosing(null, MicrobitTransfer.SAVE))
    put("choose-usb", choosing(null, MicrobitTransfer.USB, MicrobitTransfer.SAVE))
    put("choose-all", choosing(null, *MicrobitTransfer.entries.toTypedArray()))
    put("wrong-file", choosing(ChoosingProblem.OfFile("holiday.hex", ImageError.NoMicroPython)), microPython = null)
    put("too-large", choosing(ChoosingProblem.OfProgram(ImageError.TooLarge(31_004, 20_150))))
    put("wrong-micropython", choosing(ChoosingProblem.OfProgram(ImageError.OtherBoard(MicrobitBoard.V2))))
    put("not-saved", choosing(ChoosingProblem.NotSaved, MicrobitTransfer.SAVE))
    put("not-kept", choosing(ChoosingProblem.NotKept, MicrobitTransfer.SAVE))
    put("no-board", choosing(ChoosingProblem.NoBoard, MicrobitTransfer.USB, MicrobitTransfer.SAVE))
    put("looking", MicrobitSendStep.Looking)
    put("many", MicrobitSendStep.ManyBoards(BOARDS))
    put("connecting", MicrobitSendStep.Connecting)
    put("found", MicrobitSendStep.Found)
    put("found-other", MicrobitSendStep.Found, board = FoundBoard(MicrobitBoard.V1, expected = MicrobitBoard.V2))
    put("sending-begins", MicrobitSendStep.Sending(null, isWhole = false))
    put("sending-alone", MicrobitSendStep.Sending(SendProgress(1_504, 2_380, attempt = 1), isWhole = false))
    put("sending", MicrobitSendStep.Sending(SendProgress(304_000, 1_240_000, attempt = 1), isWhole = true))
    put("sending-again", MicrobitSendStep.Sending(SendProgress(504_000, 1_240_000, attempt = 2), isWhole = true))
    for (remains in Remains.entries) {
        put("cancelled-${remains.name.lowercase()}", MicrobitSendStep.Cancelled(remains))
    }
    put("running", MicrobitSendStep.Running())
    put("running-prints", MicrobitSendStep.Running(PRINTED))
    put("ended", MicrobitSendStep.Running(PRINTED.copy(hasEnded = true)))
    put("gone", MicrobitSendStep.Running(PRINTED, isGone = true))
    val error = PythonError(line = 31, "ZeroDivisionError: divide by zero")
    put("failed-at", MicrobitSendStep.Running(BoardConsole(listOf("12"), error = error), errorLine = 7))
    put("copying", MicrobitSendStep.Copying)
    put("copied", MicrobitSendStep.Copied)
    put("not-copied", MicrobitSendStep.NotCopied(""))
    put("not-copied-refused", MicrobitSendStep.NotCopied("The hex file cannot be decoded."))
    put("saved", MicrobitSendStep.HexSaved("square.hex"))
    for (kind in FlashErrorKind.entries) {
        put("number-${kind.name.lowercase()}", MicrobitSendStep.HexSaved("square.hex", ShownNumber("529", kind)))
    }
    put("saved-python", MicrobitSendStep.PythonSaved("main.py"))
    for (each in ERRORS) put("error-${each::class.simpleName?.lowercase()}", MicrobitSendStep.Failed(each))
    for (kind in FlashErrorKind.entries) {
        put("refused-${kind.name.lowercase()}", MicrobitSendStep.Failed(BoardError.Refused(21, kind)))
    }
    put("error-left", MicrobitSendStep.Failed(BoardError.BrokenOff, Remains.PART))
    put("error-whole", MicrobitSendStep.Failed(BoardError.NoRoom, Remains.PART, canSendWhole = true))
    put("error-nowhere", MicrobitSendStep.Failed(BoardError.NoPython), microPython = null)
}
