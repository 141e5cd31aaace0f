package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.language.source.Diagnostic
import robotran.legofirmware.device.DatalogEntry
import robotran.tower.LegoLimits
import robotran.tower.ReceivedMessage
import robotran.tower.Remains
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
    data class HasErrors(val first: Diagnostic) : SendStep

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

    /**
     * The pupil chooses a slot of LEGO's own firmware.
     *
     * @property last the slot of the last program; null if this is the first one.
     */
    data class ChoosingSlot(val last: Int?) : SendStep

    /** @property progress with entries in place of blocks; null until some have come. */
    data class ReadingDatalog(val progress: TransferProgress?) : SendStep {
        override val isBusy get() = true
    }

    /**
     * What a program has written into the datalog.
     *
     * @property entries empty if there is no datalog, too.
     * @property savedAs the name of its file; null if it was not saved yet.
     * @property isRefused whether the last try to save it has failed.
     */
    data class Datalog(val entries: List<DatalogEntry>, val savedAs: String? = null, val isRefused: Boolean = false) :
        SendStep

    /** @property progress null until the first block is through. */
    data class Sending(val what: Transfer, val progress: TransferProgress?) : SendStep {
        override val isBusy get() = true
    }

    /**
     * The brick needs another firmware.
     *
     * @property file the chosen file; null for none yet.
     * @property why what the brick has.
     */
    data class NeedsFirmware(val file: ChosenFirmware? = null, val why: TowerError = TowerError.NoLejos()) : SendStep {
        /** Whether it is LEGO's own that is needed, and not leJOS. */
        val needsLego get() = why !is TowerError.NoLejos

        /** What can be sent; null if there is no file yet, or not the right one. */
        val usable: FirmwareImage? get() = file?.usable(needsLego)
    }

    /**
     * The pupil has cancelled a transfer, so the brick lacks [what].
     *
     * @property slot of LEGO's firmware that was sent to; null for leJOS and for a firmware.
     */
    data class Cancelled(val what: Transfer, val slot: Int? = null) : SendStep

    /**
     * @property remains what the brick has now.
     * @property slot as of [Cancelled].
     */
    data class Failed(val error: SendError, val remains: Remains = Remains.AS_BEFORE, val slot: Int? = null) : SendStep

    /**
     * The program is in the brick.
     *
     * @property slot as of [Cancelled].
     */
    data class Done(val bytes: Int, val slot: Int? = null) : SendStep

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
    /** What can be sent; null if it is no firmware, or one that runs no programs of the kind that is sent. */
    fun usable(needsLego: Boolean): FirmwareImage? {
        val firmware = (file as? FirmwareFile.Success)?.firmware ?: return null
        val isRight = when (firmware.kind) {
            FirmwareKind.LEGO -> needsLego && !isTooOld(firmware)
            FirmwareKind.LEJOS_2_1, FirmwareKind.LEJOS_3_0 -> !needsLego
            FirmwareKind.UNKNOWN -> true
        }
        return firmware.takeIf { isRight }
    }

    companion object {
        /** Whether it is LEGO's firmware 1.0: the app makes programs for 2.0. */
        fun isTooOld(firmware: FirmwareImage): Boolean = firmware.version?.let { it < LegoLimits.VERSION_2 } ?: false
    }
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
