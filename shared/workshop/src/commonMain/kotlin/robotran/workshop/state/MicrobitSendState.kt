package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.language.source.Diagnostic
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.SendProgress
import robotran.microbitlink.dap.PluggedBoard
import robotran.microbitlink.serial.BoardConsole

/**
 * A program on its way onto a micro:bit.
 *
 * @property program its name.
 * @property size how much of a board it fills; null before it is built.
 * @property microPython the file with MicroPython that was chosen, now or earlier; null for none.
 * @property board the board that is connected, or was last; null before the first.
 */
@Immutable
data class MicrobitSendState(
    val program: String,
    val step: MicrobitSendStep,
    val size: ProgramSize? = null,
    val microPython: FoundMicroPython? = null,
    val board: FoundBoard? = null,
)

/**
 * How much of a board a program fills.
 *
 * @property maxBytes the room of the smallest board that the chosen file is for, or of the robot's.
 * @property memoryShare how full the board's memory gets, from 0 to 1; 0 if its room for files is full before.
 */
data class ProgramSize(val bytes: Int, val maxBytes: Int, val memoryShare: Float = 0f) {
    /** How full the board gets, from 0 to 1. */
    val share: Float get() = maxOf(bytes.toFloat() / maxBytes, memoryShare).coerceIn(0f, 1f)
}

/**
 * A file with MicroPython.
 *
 * @property file its name.
 * @property versions such as 2.1.2, for each board that it is for; empty texts for those that do not tell.
 */
data class FoundMicroPython(val file: String, val versions: Map<MicrobitBoard, String>)

/**
 * What a connected board is.
 *
 * @property expected the board of the program's robot if this is the other one.
 */
data class FoundBoard(val board: MicrobitBoard, val expected: MicrobitBoard? = null)

/** A step on the way onto a board. */
sealed interface MicrobitSendStep {
    /** Whether something is under way that can be cancelled. */
    val isBusy: Boolean get() = false

    /** The program becomes Python. */
    data object Building : MicrobitSendStep {
        override val isBusy get() = true
    }

    /**
     * The program cannot go onto a board.
     *
     * @property first the first diagnostic.
     */
    data class HasErrors(val first: Diagnostic) : MicrobitSendStep

    /** The program did not become Python, because of a bug. */
    data object CompilerFailed : MicrobitSendStep

    /**
     * The pupil chooses MicroPython, and how the program gets onto the board.
     *
     * @property transfers what can be done here.
     * @property problem why what was tried last did not work; null if nothing was.
     */
    data class Choosing(val transfers: Set<MicrobitTransfer>, val problem: ChoosingProblem? = null) : MicrobitSendStep

    /** The platform looks for a board, or shows its dialog for that. */
    data object Looking : MicrobitSendStep {
        override val isBusy get() = true
    }

    /** There are several boards, and the pupil takes one. */
    data class ManyBoards(val boards: List<PluggedBoard>) : MicrobitSendStep

    data object Connecting : MicrobitSendStep {
        override val isBusy get() = true
    }

    /** A board that was not used before is connected, or not the robot's. */
    data object Found : MicrobitSendStep

    /**
     * @property progress null until the board has begun.
     * @property isWhole whether MicroPython is sent, too.
     */
    data class Sending(val progress: SendProgress?, val isWhole: Boolean) : MicrobitSendStep {
        override val isBusy get() = true
    }

    /** The pupil has cancelled. [remains] is what the board has now. */
    data class Cancelled(val remains: Remains) : MicrobitSendStep

    /**
     * The program is on the board and has started.
     *
     * @property console what it prints.
     * @property errorLine the pupil's line at which it has failed; null if it has not, or if that is not known.
     * @property isGone whether the board is not connected any more: its program goes on.
     */
    data class Running(
        val console: BoardConsole = BoardConsole(),
        val errorLine: Int? = null,
        val isGone: Boolean = false,
    ) : MicrobitSendStep

    /** The file is copied onto the drive of a board. */
    data object Copying : MicrobitSendStep {
        override val isBusy get() = true
    }

    /** The file is on the board, by its drive. */
    data object Copied : MicrobitSendStep

    /** The board, or the system, did not take the file on its drive. [words] are the board's own; empty for none. */
    data class NotCopied(val words: String) : MicrobitSendStep

    /** MicroPython with the program in it is saved as [file], and has still to be copied. */
    data class HexSaved(val file: String, val number: ShownNumber = ShownNumber()) : MicrobitSendStep

    /** The program is saved as Python. */
    data class PythonSaved(val file: String) : MicrobitSendStep

    /**
     * @property remains what the board has now.
     * @property canSendWhole whether sending MicroPython, too, may help.
     */
    data class Failed(
        val error: BoardError,
        val remains: Remains = Remains.AS_BEFORE,
        val canSendWhole: Boolean = false,
    ) : MicrobitSendStep
}

/** How a program gets onto a board. */
enum class MicrobitTransfer {
    /** By USB, from the app itself. */
    USB,

    /** Onto the drive of a board. */
    DRIVE,

    /** As a file that the pupil copies. */
    SAVE,
}

/** Why something at the beginning did not work. */
sealed interface ChoosingProblem {
    /** The [file] that was chosen, or the program with it, is no good. */
    data class OfFile(val file: String, val error: ImageError) : ChoosingProblem

    /** The program is too large, or the MicroPython that was chosen earlier is not for its robot. */
    data class OfProgram(val error: ImageError) : ChoosingProblem

    /** The file could not be saved. */
    data object NotSaved : ChoosingProblem

    /** MicroPython serves now, but is not kept for the next time. */
    data object NotKept : ChoosingProblem

    /** No board was chosen. */
    data object NoBoard : ChoosingProblem

    /** There are drives of several boards, and nothing tells which is the pupil's. */
    data object SeveralBoards : ChoosingProblem
}

/**
 * The number that a board shows when it has refused a file.
 *
 * @property text as it is typed.
 * @property kind what it means; null as long as it is none.
 */
data class ShownNumber(val text: String = "", val kind: FlashErrorKind? = null)
