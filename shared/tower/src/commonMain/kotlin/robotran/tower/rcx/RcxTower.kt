package robotran.tower.rcx

import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.legofirmware.device.DatalogEntry
import robotran.legofirmware.image.RcxImage
import robotran.tower.BrickMemory
import robotran.tower.BrickStatus
import robotran.tower.LegoLimits
import robotran.tower.RcxOpcode
import robotran.tower.ReceivedMessage
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.Wait
import robotran.tower.firmware.FirmwareImage
import robotran.tower.line.MessageReader
import robotran.tower.line.Received
import robotran.tower.line.Reply
import robotran.tower.line.Requests
import robotran.tower.port.TowerPort

/**
 * Talks to an RCX through an open tower. Nothing here has been tried on a real brick, see `docs/tower.md`.
 *
 * Every call wakes the tower first and may be cancelled at any moment. Calls wait for each other.
 */
class RcxTower(private val port: TowerPort) {
    private val requests = Requests(port)
    private val oneAtATime = Mutex()

    /**
     * Whether there is a tower at the port, as far as a short look tells: a serial one hears itself. For a port that
     * nobody has named as that of the tower; the other calls take longer to be sure.
     */
    suspend fun isThere(): Boolean = exclusively { hearsItself(requests.line) }

    /** Whether a brick answers. */
    suspend fun alive(): TowerResult<Unit> = exclusively { requests.reach().asResult() }

    /** What the brick is. It keeps its program and its firmware. */
    suspend fun status(): TowerResult<BrickStatus> = exclusively { readStatus(requests) }

    /** The voltage of the batteries in mV, which only LEGO's firmware tells. */
    suspend fun battery(): TowerResult<Int> = exclusively {
        requests.reach()?.let { return@exclusively TowerResult.Failure(it) }
        readBattery(requests)
    }

    /**
     * Sends a program to leJOS, which has room for one image. The image may hold several programs.
     *
     * From the first message on, the program that was on the brick is gone. If the call fails or is cancelled, the brick
     * has no program that it could run.
     *
     * @param image begins with CA F6.
     * @param maxBytes how large an image the brick takes. It depends on the version of leJOS, which a brick does not tell.
     * @param report is called after each block and each attempt in vain.
     */
    suspend fun sendProgram(
        image: ByteArray,
        maxBytes: Int = BrickMemory.MAX_LEJOS_IMAGE,
        report: (TransferProgress) -> Unit = {},
    ): TransferResult {
        require(image.size > 1 && image[0] == 0xCA.toByte() && image[1] == 0xF6.toByte()) { "not an image for leJOS" }
        return exclusively { downloadProgram(requests, image, maxBytes, report) }
    }

    /**
     * Sends a firmware, which replaces the one on the brick with all its programs.
     *
     * If the call fails or is cancelled, the brick has no firmware, and waits for one.
     */
    suspend fun sendFirmware(firmware: FirmwareImage, report: (TransferProgress) -> Unit = {}): TransferResult =
        exclusively { downloadFirmware(requests, firmware, report) }

    /**
     * Sends a program into [slot], 1 to 5, of LEGO's firmware. leJOS has no slots.
     *
     * If the call is cancelled, the slot has no main task, or what it had before if that was early.
     */
    suspend fun sendLegoProgram(
        slot: Int,
        program: RcxImage,
        report: (TransferProgress) -> Unit = {},
    ): TransferResult {
        requireSlot(slot)
        return exclusively { downloadLegoProgram(requests, slot, program, report) }
    }

    /** Selects [slot], 1 to 5, of LEGO's firmware, which stops the running program. */
    suspend fun selectLegoSlot(slot: Int): TowerResult<Unit> {
        requireSlot(slot)
        return legoCommand(selectSlot(slot))
    }

    /** Deletes the tasks and subroutines in [slot], 1 to 5, of LEGO's firmware, and leaves the slot selected. */
    suspend fun deleteLegoProgram(slot: Int): TowerResult<Unit> {
        requireSlot(slot)
        return legoCommand(
            selectSlot(slot),
            byteArrayOf(RcxOpcode.DELETE_TASKS.toByte()),
            byteArrayOf(RcxOpcode.DELETE_SUBROUTINES.toByte()),
        )
    }

    /** Starts the main task of the selected slot of LEGO's firmware. */
    suspend fun startLegoProgram(): TowerResult<Unit> =
        legoCommand(byteArrayOf(RcxOpcode.START_TASK.toByte(), MAIN_TASK))

    /** Stops all tasks of LEGO's firmware. */
    suspend fun stopLegoProgram(): TowerResult<Unit> = legoCommand(byteArrayOf(RcxOpcode.STOP.toByte()))

    /**
     * The datalog of LEGO's firmware, without the first entry, which only counts the others; empty if there is none. The
     * brick keeps it.
     *
     * @param report is called with entries in place of blocks.
     */
    suspend fun readLegoDatalog(report: (TransferProgress) -> Unit = {}): TowerResult<List<DatalogEntry>> =
        exclusively { readDatalog(requests, report) }

    /** Sets the clock of LEGO's firmware. */
    suspend fun setLegoClock(hours: Int, minutes: Int): TowerResult<Unit> {
        require(hours in 0..23 && minutes in 0..59) { "$hours:$minutes is no time" }
        return legoCommand(byteArrayOf(RcxOpcode.SET_CLOCK.toByte(), hours.toByte(), minutes.toByte()))
    }

    /**
     * Sends a message of one number, 1 to 255, to the robots in sight. Nobody answers it, so success means only that the
     * tower has sent it.
     */
    suspend fun sendMessage(number: Int): TowerResult<Unit> {
        require(number in 1..0xFF) { "$number is no message" }
        return exclusively {
            requests.wake()?.let { return@exclusively TowerResult.Failure(it) }
            val message = requests.next(byteArrayOf(RcxOpcode.MESSAGE.toByte(), number.toByte()))
            val isSent = requests.line.sendOnly(message)
            (if (isSent) null else TowerError.TowerGone).asResult()
        }
    }

    /** What robots send, until the tower is gone. No other call gets its turn while this is collected. */
    fun messages(): Flow<ReceivedMessage> = flow {
        oneAtATime.withLock {
            if (requests.wake() != null) return@withLock
            val reader = MessageReader()
            var silence = 0
            while (true) {
                val wait = if (reader.isWaiting) Wait.MESSAGE_GAP else Wait.KEEP_AWAKE
                val found = when (val received = requests.line.receive(wait)) {
                    is Received.Bytes -> reader.add(received.bytes).also { silence = 0 }
                    Received.Nothing -> reader.pause().also { silence += wait }
                    Received.Gone -> return@withLock
                }
                found.forEach { emit(it) }
                if (silence >= Wait.KEEP_AWAKE) {
                    silence = 0
                    val heard = requests.line.keepAwake() ?: return@withLock
                    reader.add(heard).forEach { emit(it) }
                }
            }
        }
    }

    /** Releases the tower. */
    suspend fun close() = port.close()

    private suspend fun legoCommand(vararg messages: ByteArray): TowerResult<Unit> = exclusively {
        when (val versions = legoVersions(requests)) {
            is TowerResult.Failure -> return@exclusively versions
            is TowerResult.Success -> Unit
        }
        for (message in messages) {
            val reply = requests.request(message, 0)
            if (reply is Reply.Failure) return@exclusively TowerResult.Failure(reply.error)
        }
        TowerResult.Success(Unit)
    }

    private suspend fun <T> exclusively(work: suspend () -> T): T = oneAtATime.withLock { work() }

    private fun requireSlot(slot: Int) = require(slot in 1..LegoLimits.SLOTS) { "there is no slot $slot" }

    private companion object {
        const val MAIN_TASK: Byte = 0
    }
}

private fun TowerError?.asResult(): TowerResult<Unit> =
    if (this == null) TowerResult.Success(Unit) else TowerResult.Failure(this)
