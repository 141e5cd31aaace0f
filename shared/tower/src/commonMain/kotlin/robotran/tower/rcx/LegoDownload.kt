package robotran.tower.rcx

import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.withContext
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.tower.LegoLimits
import robotran.tower.RcxOpcode
import robotran.tower.Remains
import robotran.tower.Status
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.Tries
import robotran.tower.line.Reply
import robotran.tower.line.Requests
import robotran.tower.line.twoBytes
import robotran.tower.transfer.BlockRules
import robotran.tower.transfer.BlockSender
import robotran.tower.transfer.BlocksResult
import robotran.tower.transfer.ProgressMeter

/**
 * Sends [program] into a slot of LEGO's firmware. The main task comes last, so that a slot whose download ends early
 * has nothing to run; what is there then is deleted, as far as the brick still answers.
 */
internal suspend fun downloadLegoProgram(
    requests: Requests,
    slot: Int,
    program: RcxImage,
    report: (TransferProgress) -> Unit,
): TransferResult {
    refusal(requests, program)?.let { return TransferResult.Failure(it) }
    val download = LegoDownload(requests, slot, program, report)
    val error = try {
        download.send()
    } catch (cancelled: CancellationException) {
        withContext(NonCancellable) { download.remove() }
        throw cancelled
    }
    return withContext(NonCancellable) { if (error == null) download.end() else download.failed(error) }
}

/** Why the brick cannot take [program]; it is asked, and nothing is changed. */
private suspend fun refusal(requests: Requests, program: RcxImage): TowerError? {
    val version = when (val versions = legoVersions(requests)) {
        is TowerResult.Failure -> return versions.error
        is TowerResult.Success -> versions.value.firmware
    }
    if (program.target == FirmwareTarget.RCX2 &&
        version < LegoLimits.VERSION_2
    ) {
        return TowerError.LegoFirmwareTooOld(version)
    }
    return when (val battery = readBattery(requests)) {
        is TowerResult.Failure -> battery.error

        is TowerResult.Success -> {
            battery.value.takeIf { it < LegoLimits.MIN_MILLIVOLTS }
                ?.let { TowerError.BatteryLow(it) }
        }
    }
}

/** The versions of a brick with LEGO's firmware; an error if it has another one. */
internal suspend fun legoVersions(requests: Requests): TowerResult<Versions> {
    requests.reach()?.let { return TowerResult.Failure(it) }
    return when (val versions = readVersions(requests)) {
        is TowerResult.Success -> versions.takeIf { it.value.hasFirmware } ?: NO_LEGO_FIRMWARE

        // A brick that is there, but does not tell its versions, has a firmware of its own.
        is TowerResult.Failure -> if (versions.error == TowerError.BrickSilent) {
            requests.reach()?.let { TowerResult.Failure(it) } ?: NO_LEGO_FIRMWARE
        } else {
            versions
        }
    }
}

/** `selectSlot(1)` selects the first slot. */
internal fun selectSlot(slot: Int): ByteArray = byteArrayOf(RcxOpcode.SELECT_SLOT.toByte(), (slot - 1).toByte())

/** One download to a brick that can take it. */
private class LegoDownload(
    private val requests: Requests,
    private val slot: Int,
    program: RcxImage,
    report: (TransferProgress) -> Unit,
) {
    /** A task or subroutine without code does what one does that is not there: nothing. */
    private val parts = program.chunks.filter { it.code.size > 0 }.sortedWith(ORDER)
    private val total = program.codeSize
    private val progress = ProgressMeter(total, report)
    private var isEmptied = false
    private var isMainBegun = false

    /** Empties the slot and sends all parts; the error if that fails. */
    suspend fun send(): TowerError? {
        val messages = listOf(byteArrayOf(RcxOpcode.STOP.toByte()), selectSlot(slot), DELETE_TASKS, DELETE_SUBROUTINES)
        for (message in messages) {
            val reply = requests.request(message, 0)
            if (reply is Reply.Failure) return reply.error
            if (message === DELETE_TASKS) isEmptied = true
        }
        return parts.firstNotNullOfOrNull { sendPart(it) }
    }

    private suspend fun sendPart(part: Chunk): TowerError? {
        if (part.id == ChunkId.MAIN) isMainBegun = true
        val sender = BlockSender(requests, LEGO_RULES, progress)
        val opcode = if (part.id.kind == ChunkKind.TASK) RcxOpcode.BEGIN_TASK else RcxOpcode.BEGIN_SUBROUTINE
        val code = part.code.toByteArray()
        val begin = byteArrayOf(opcode.toByte(), 0, part.id.number.toByte(), 0) + twoBytes(code.size)
        repeat(Tries.DOWNLOAD) {
            when (val reply = requests.request(begin, 1)) {
                is Reply.Failure -> return reply.error
                is Reply.Success -> if (reply.payload.single().toInt() == Status.NO_MEMORY) return noRoom()
            }
            when (val result = sender.send(code)) {
                BlocksResult.Complete -> return null.also { progress.partIsComplete() }
                BlocksResult.NoMemory -> return noRoom()
                is BlocksResult.Failed -> return result.error
                is BlocksResult.BeginAgain -> Unit
            }
        }
        return sender.lastError
    }

    /** LEGO's firmware does not tell how much room it has. */
    private fun noRoom() = TowerError.TooLarge(total, maxBytes = null)

    /** All parts are there: the brick plays a sound, which nothing depends on. */
    suspend fun end(): TransferResult {
        requests.request(byteArrayOf(RcxOpcode.PLAY_SOUND.toByte(), UP_SOUND), 0, Tries.CLEAN_UP)
        return TransferResult.Success(total, progress.repeats)
    }

    /** Deletes what is in the slot, and tells what is there then. */
    suspend fun failed(error: TowerError): TransferResult.Failure {
        val isRemoved = error != TowerError.TowerGone && remove()
        val isEmpty = isRemoved || (isEmptied && !isMainBegun)
        return TransferResult.Failure(error, if (isEmpty) Remains.NO_PROGRAM else Remains.UNKNOWN)
    }

    /** Deletes what is in the slot. False if the brick did not answer, or the slot may not be the selected one. */
    suspend fun remove(): Boolean {
        if (!isEmptied) return false
        val isRemoved = requests.request(DELETE_TASKS, 0, Tries.CLEAN_UP) is Reply.Success
        // Subroutines do nothing alone, but take room.
        if (isRemoved) requests.request(DELETE_SUBROUTINES, 0, Tries.CLEAN_UP)
        return isRemoved
    }
}

private val NO_LEGO_FIRMWARE = TowerResult.Failure(TowerError.NoLegoFirmware)
private val ORDER =
    compareBy<Chunk> { it.id.kind == ChunkKind.TASK }.thenBy { it.id == ChunkId.MAIN }.thenBy { it.id.number }
private val LEGO_RULES = BlockRules(minBlocks = 1, lastIsZero = true)
private val DELETE_TASKS = byteArrayOf(RcxOpcode.DELETE_TASKS.toByte())
private val DELETE_SUBROUTINES = byteArrayOf(RcxOpcode.DELETE_SUBROUTINES.toByte())

/** The quick rising sound, with which nqc ends a download, too. */
private const val UP_SOUND: Byte = 5
