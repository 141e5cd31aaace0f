package robotran.tower.rcx

import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.withContext
import robotran.tower.LegoLimits
import robotran.tower.LegoPartKind
import robotran.tower.LegoProgram
import robotran.tower.LegoProgramPart
import robotran.tower.Opcode
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
    program: LegoProgram,
    report: (TransferProgress) -> Unit,
): TransferResult {
    prepare(requests, slot)?.let { return TransferResult.Failed(it) }
    val total = program.parts.sumOf { it.code.size }
    val progress = ProgressMeter(total, report)
    var isComplete = false
    try {
        for (part in program.parts.sortedWith(ORDER)) {
            sendPart(requests, part, progress)?.let { return TransferResult.Failed(it) }
        }
        isComplete = true
        return TransferResult.Complete(total, progress.repeats)
    } finally {
        if (!isComplete) withContext(NonCancellable) { requests.request(DELETE_TASKS, 0, Tries.CLEAN_UP) }
    }
}

/** Checks firmware and batteries, selects the slot and empties it. */
private suspend fun prepare(requests: Requests, slot: Int): TowerError? {
    requests.reach()?.let { return it }
    when (val versions = readVersions(requests)) {
        is TowerResult.Failed -> return versions.error
        is TowerResult.Success -> if (!versions.value.hasFirmware) return TowerError.NoLegoFirmware
    }
    when (val battery = readBattery(requests)) {
        is TowerResult.Failed -> return battery.error

        is TowerResult.Success -> if (battery.value < LegoLimits.MIN_MILLIVOLTS) {
            return TowerError.BatteryLow(battery.value)
        }
    }
    val messages = listOf(byteArrayOf(Opcode.STOP.toByte()), selectSlot(slot), DELETE_TASKS, DELETE_SUBROUTINES)
    return messages.firstNotNullOfOrNull { (requests.request(it, 0) as? Reply.Failed)?.error }
}

/** `selectSlot(1)` selects the first slot. */
internal fun selectSlot(slot: Int): ByteArray = byteArrayOf(Opcode.SELECT_SLOT.toByte(), (slot - 1).toByte())

private suspend fun sendPart(requests: Requests, part: LegoProgramPart, progress: ProgressMeter): TowerError? {
    val sender = BlockSender(requests, LEGO_RULES, progress)
    val opcode = if (part.kind == LegoPartKind.TASK) Opcode.BEGIN_TASK else Opcode.BEGIN_SUBROUTINE
    val begin = byteArrayOf(opcode.toByte(), 0, part.number.toByte(), 0) + twoBytes(part.code.size)
    repeat(Tries.DOWNLOAD) {
        when (val reply = requests.request(begin, 1)) {
            is Reply.Failed -> return reply.error
            is Reply.Answered -> if (reply.payload.single().toInt() == Status.NO_MEMORY) return noRoom(part)
        }
        when (val result = sender.send(part.code)) {
            BlocksResult.Complete -> return null.also { progress.partIsComplete() }
            BlocksResult.NoMemory -> return noRoom(part)
            is BlocksResult.Failed -> return result.error
            is BlocksResult.BeginAgain -> Unit
        }
    }
    return sender.lastError
}

/** LEGO's firmware does not tell how much room it has. */
private fun noRoom(part: LegoProgramPart) = TowerError.TooLarge(part.code.size, maxBytes = null)

private val ORDER =
    compareBy<LegoProgramPart> { it.kind == LegoPartKind.TASK }.thenBy { it.number == 0 }.thenBy { it.number }
private val LEGO_RULES = BlockRules(minBlocks = 1, lastIsZero = true)
private val DELETE_TASKS = byteArrayOf(Opcode.DELETE_TASKS.toByte())
private val DELETE_SUBROUTINES = byteArrayOf(Opcode.DELETE_SUBROUTINES.toByte())
