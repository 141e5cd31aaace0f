package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.programs.ProgramDiagnostic
import robotran.tower.ReceivedMessage
import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.OpenFailure
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind

/**
 * Sending a program to a real robot.
 *
 * @property program the name of the program that is sent.
 */
@Immutable
data class SendState(val program: String, val step: SendStep)

/** A step of sending. */
sealed interface SendStep {
    /** Whether something is under way that can be cancelled. */
    val isBusy: Boolean get() = false

    /** The program is compiled and linked. */
    data object Building : SendStep {
        override val isBusy get() = true
    }

    /**
     * The program cannot become an image.
     *
     * @property first the first diagnostic.
     */
    data class HasErrors(val first: ProgramDiagnostic) : SendStep

    /** The Java compiler could not be loaded. */
    data object NoCompiler : SendStep

    /** The compiler crashed on the program because of a bug. */
    data object CompilerFailed : SendStep

    /** This platform reaches no tower, such as a browser without Web Serial. */
    data object NoTowers : SendStep

    /**
     * The pupil chooses a tower.
     *
     * @property devices the towers that can be opened at once, the likeliest first.
     * @property kinds the kinds that the platform can be asked for.
     * @property isMissing whether the last question ended without a tower.
     */
    data class ChoosingTower(
        val devices: List<TowerDevice>,
        val kinds: List<TowerKind>,
        val isMissing: Boolean = false,
    ) : SendStep

    /** The tower is opened, and the brick asked whether it is there. */
    data object Checking : SendStep {
        override val isBusy get() = true
    }

    /** @property progress null until the first block is through. */
    data class Sending(val what: Transfer, val progress: TransferProgress?) : SendStep {
        override val isBusy get() = true
    }

    /**
     * The brick needs leJOS's firmware.
     *
     * @property file the chosen file; null for none yet.
     */
    data class NeedsFirmware(val file: ChosenFirmware? = null) : SendStep

    /** The pupil has cancelled a transfer, so the brick lacks [what]. */
    data class Cancelled(val what: Transfer) : SendStep

    data class Failed(val error: SendError) : SendStep

    /** The program is in the brick. */
    data class Done(val bytes: Int) : SendStep

    /**
     * Messages from the robot.
     *
     * @property messages oldest first, at most [MAX_MESSAGES].
     * @property isOver whether the tower is gone.
     */
    data class Watching(val messages: List<RobotMessage>, val isOver: Boolean = false) : SendStep

    companion object {
        /** Older messages are forgotten. */
        const val MAX_MESSAGES = 200
    }
}

/** What is transferred to the brick. */
enum class Transfer { PROGRAM, FIRMWARE }

/** A firmware file that the pupil has chosen. */
data class ChosenFirmware(val name: String, val file: FirmwareFile) {
    /** What can be sent; null if it is no firmware, or LEGO's, which runs no programs of leJOS. */
    val usable: FirmwareImage?
        get() = (file as? FirmwareFile.Read)?.firmware?.takeIf { it.kind != FirmwareKind.LEGO }
}

/** Why sending has failed. */
sealed interface SendError {
    data class OfTower(val error: TowerError) : SendError

    data class OfPort(val failure: OpenFailure, val kind: TowerKind) : SendError
}

/**
 * Something that the robot has sent.
 *
 * @property number differs for all messages of a list.
 * @property milliseconds since watching began.
 */
data class RobotMessage(val number: Int, val milliseconds: Long, val received: ReceivedMessage)
