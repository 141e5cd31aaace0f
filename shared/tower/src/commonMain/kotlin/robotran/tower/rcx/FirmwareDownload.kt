package robotran.tower.rcx

import kotlinx.coroutines.delay
import robotran.tower.Key
import robotran.tower.RcxOpcode
import robotran.tower.Remains
import robotran.tower.Status
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.Tries
import robotran.tower.Wait
import robotran.tower.firmware.FirmwareImage
import robotran.tower.line.Attempt
import robotran.tower.line.Reply
import robotran.tower.line.Requests
import robotran.tower.line.pairsFrom
import robotran.tower.line.twoBytes
import robotran.tower.transfer.BlockRules
import robotran.tower.transfer.BlockSender
import robotran.tower.transfer.BlocksResult
import robotran.tower.transfer.ProgressMeter
import kotlin.time.Duration.Companion.milliseconds

/**
 * Sends a firmware. Whenever it is cancelled, the brick has no firmware and its ROM answers: a firmware begins to run only
 * once the ROM has checked its sum.
 */
internal suspend fun downloadFirmware(
    requests: Requests,
    firmware: FirmwareImage,
    report: (TransferProgress) -> Unit,
): TransferResult {
    requests.reach()?.let { return TransferResult.Failure(it) }
    val progress = ProgressMeter(firmware.bytes.size, report)
    val sender = BlockSender(requests, ROM_RULES, progress)
    var refusals = 0
    repeat(Tries.DOWNLOAD) { tries ->
        beginFirmware(requests, firmware)?.let { return failedToBegin(it, isFirst = tries == 0) }
        val blocks = sender.send(firmware.bytes)
        if (blocks is BlocksResult.Failed) return without(blocks.error)
        if (blocks == BlocksResult.NoMemory) return REFUSED
        if (blocks == BlocksResult.Complete) {
            when (val unlocked = unlock(requests)) {
                Unlocked.Running -> return TransferResult.Success(firmware.bytes.size, progress.repeats)
                Unlocked.Refused -> if (++refusals == MAX_REFUSALS) return REFUSED
                is Unlocked.Failed -> return TransferResult.Failure(unlocked.error, Remains.UNKNOWN)
            }
        }
    }
    return without(sender.lastError)
}

private fun without(error: TowerError) = TransferResult.Failure(error, Remains.NO_FIRMWARE)

/** A brick that was not heard may have understood, and then has deleted its firmware. */
private fun failedToBegin(error: TowerError, isFirst: Boolean) = when {
    isFirst && error != TowerError.FirmwareRefused -> TransferResult.Failure(error, Remains.UNKNOWN)
    else -> without(error)
}

private suspend fun beginFirmware(requests: Requests, firmware: FirmwareImage): TowerError? {
    val delete = byteArrayOf(RcxOpcode.DELETE_FIRMWARE.toByte()) + Key.PRIMES
    (requests.request(delete, 0) as? Reply.Failure)?.let { return it.error }
    val begin =
        byteArrayOf(RcxOpcode.BEGIN_FIRMWARE.toByte()) + twoBytes(firmware.start) + twoBytes(firmware.checksum) + 0
    return when (val reply = requests.request(begin, 1)) {
        is Reply.Failure -> reply.error
        is Reply.Success -> TowerError.FirmwareRefused.takeUnless { reply.payload.single().toInt() == Status.GOOD }
    }
}

/** The result of unlocking. */
private sealed interface Unlocked {
    data object Running : Unlocked

    /** The ROM says that the firmware's checksum is wrong, or does not start it. */
    data object Refused : Unlocked

    data class Failed(val error: TowerError) : Unlocked
}

private suspend fun unlock(requests: Requests): Unlocked {
    val message = requests.next(byteArrayOf(RcxOpcode.UNLOCK_FIRMWARE.toByte()) + Key.LEGO)
    repeat(Tries.UNLOCK) {
        delay(Wait.BEFORE_UNLOCK.milliseconds)
        when (val result = requests.line.attempt(message, UNLOCK_TEXT_BYTES, Wait.FOR_UNLOCK)) {
            is Attempt.Answered -> return Unlocked.Running
            is Attempt.Unanswered -> partOfAnswer(result.rest, message)?.let { return it }
            Attempt.Gone -> return Unlocked.Failed(TowerError.TowerGone)
        }
        // A firmware that runs does not answer the resend.
        when (val reply = requests.firmwareRuns()) {
            is TowerResult.Success -> if (reply.value) return Unlocked.Running
            is TowerResult.Failure -> return Unlocked.Failed(reply.error)
        }
    }
    return Unlocked.Refused
}

/** What the undamaged beginning of an answer to unlocking tells: the text, or one byte of status. */
private fun partOfAnswer(rest: ByteArray, message: ByteArray): Unlocked? {
    val first = message.first().toInt().inv().toByte()
    val start = rest.indexOfFirst { it == first }
    if (start < 0) return null
    val bytes = pairsFrom(rest, start)
    return when {
        bytes.size > STATUS_BYTES -> Unlocked.Running
        bytes.size == STATUS_BYTES && bytes[1].toInt() == Status.WRONG_FIRMWARE_CHECKSUM -> Unlocked.Refused
        else -> null
    }
}

private val REFUSED = without(TowerError.FirmwareRefused)
private val ROM_RULES = BlockRules(minBlocks = 1, lastIsZero = false)

/** `Just a bit off the block!` */
private const val UNLOCK_TEXT_BYTES = 25

/** The complement of the opcode, the status, and the checksum. */
private const val STATUS_BYTES = 3

/** Whole downloads that the ROM refuses before the file must be wrong. */
private const val MAX_REFUSALS = 2
