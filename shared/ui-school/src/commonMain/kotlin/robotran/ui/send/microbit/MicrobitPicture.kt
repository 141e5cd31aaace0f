package robotran.ui.send.microbit

import androidx.compose.ui.graphics.drawscope.DrawScope
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.ui.send.drawError
import robotran.uikit.*
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep

/** A small picture of what happens between app and board, or of what to do. */
enum class MicrobitPicture(val draw: DrawScope.(RobotranColours) -> Unit) {
    /** A program, and a line of it in red. */
    MISTAKE({ drawError(it) }),
    PROGRAM({ drawProgramToMicrobit(it) }),
    MICROPYTHON({ drawNeedsMicroPython(it) }),
    PLUG_IN({ drawPlugInMicrobit(it) }),
    CONNECTED({ drawConnectedMicrobit(it) }),
    SENDING({ drawSendingToMicrobit(it) }),
    PRESS_A({ drawPressA(it) }),
    COPY({ drawCopyToDrive(it) }),

    /** The face that a board shows when it has refused a file. */
    SAD({ drawSad() }),
    UNPLUGGED({ drawUnpluggedMicrobit(it) }),

    /** Another window has it. */
    TAKEN({ drawTakenMicrobit(it) }),
    LOCKED({ drawLockedMicrobit(it) }),
    WRONG_BOARD({ drawWrongMicrobit(it) }),
    WRONG_FILE({ drawWrongFile(it) }),
    NO_ROOM({ drawNoRoomInMicrobit(it) }),
}

internal fun microbitPictureOf(state: MicrobitSendState): MicrobitPicture = when (val step = state.step) {
    MicrobitSendStep.Building -> MicrobitPicture.PROGRAM
    is MicrobitSendStep.HasErrors, MicrobitSendStep.CompilerFailed -> MicrobitPicture.MISTAKE
    is MicrobitSendStep.Choosing -> pictureOf(step.problem, hasMicroPython = state.microPython != null)
    MicrobitSendStep.Looking, is MicrobitSendStep.ManyBoards, MicrobitSendStep.Connecting -> MicrobitPicture.PLUG_IN

    MicrobitSendStep.Found ->
        if (state.board?.expected == null) MicrobitPicture.CONNECTED else MicrobitPicture.WRONG_BOARD

    is MicrobitSendStep.Sending -> MicrobitPicture.SENDING
    is MicrobitSendStep.Cancelled -> MicrobitPicture.WRONG_BOARD
    is MicrobitSendStep.Running -> if (step.console.error == null) MicrobitPicture.PRESS_A else MicrobitPicture.MISTAKE
    MicrobitSendStep.Copying, is MicrobitSendStep.PythonSaved -> MicrobitPicture.COPY
    MicrobitSendStep.Copied -> MicrobitPicture.PRESS_A
    is MicrobitSendStep.NotCopied -> if (step.words.isEmpty()) MicrobitPicture.UNPLUGGED else MicrobitPicture.SAD
    is MicrobitSendStep.HexSaved -> MicrobitPicture.PLUG_IN
    is MicrobitSendStep.Failed -> pictureOf(step.error)
}

private fun pictureOf(problem: ChoosingProblem?, hasMicroPython: Boolean): MicrobitPicture = when (problem) {
    is ChoosingProblem.OfFile -> pictureOf(problem.error)
    is ChoosingProblem.OfProgram -> pictureOf(problem.error)
    ChoosingProblem.NoBoard, ChoosingProblem.SeveralBoards -> MicrobitPicture.UNPLUGGED

    ChoosingProblem.NotSaved, ChoosingProblem.NotKept, null ->
        if (hasMicroPython) MicrobitPicture.PROGRAM else MicrobitPicture.MICROPYTHON
}

private fun pictureOf(error: ImageError): MicrobitPicture = when (error) {
    is ImageError.TooLarge -> MicrobitPicture.NO_ROOM
    is ImageError.OtherBoard -> MicrobitPicture.WRONG_BOARD
    is ImageError.EmptyFile, is ImageError.BadName -> MicrobitPicture.MISTAKE
    else -> MicrobitPicture.WRONG_FILE
}

private fun pictureOf(error: BoardError): MicrobitPicture = when (error) {
    BoardError.OutOfReach, BoardError.BrokenOff -> MicrobitPicture.UNPLUGGED
    BoardError.Taken -> MicrobitPicture.TAKEN
    BoardError.NotAllowed -> MicrobitPicture.LOCKED
    BoardError.InterfaceTooOld -> MicrobitPicture.COPY
    BoardError.NotAMicrobit, BoardError.NoPython, BoardError.BadConnection -> MicrobitPicture.WRONG_BOARD
    is BoardError.BadFile -> pictureOf(error.error)
    is BoardError.Refused -> pictureOf(error.kind)
    BoardError.NoRoom -> MicrobitPicture.NO_ROOM
    BoardError.NotAsSent -> MicrobitPicture.UNPLUGGED
}

/** For a number that somebody has read off a board, too. */
internal fun pictureOf(kind: FlashErrorKind): MicrobitPicture = when (kind) {
    FlashErrorKind.OTHER_BOARD, FlashErrorKind.NOT_FOR_THIS_BOARD -> MicrobitPicture.WRONG_BOARD
    FlashErrorKind.UNKNOWN_FILE, FlashErrorKind.LOCKED, FlashErrorKind.UPDATE -> MicrobitPicture.WRONG_FILE
    FlashErrorKind.TIMED_OUT, FlashErrorKind.INTERNAL, FlashErrorKind.RESET -> MicrobitPicture.UNPLUGGED
    FlashErrorKind.OUT_OF_ORDER -> MicrobitPicture.TAKEN
    FlashErrorKind.TRANSFER, FlashErrorKind.SIZE, FlashErrorKind.CHECKSUM -> MicrobitPicture.COPY
    FlashErrorKind.WRITING, FlashErrorKind.UNKNOWN -> MicrobitPicture.SAD
}
