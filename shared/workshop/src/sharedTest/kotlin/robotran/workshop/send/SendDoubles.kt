package robotran.workshop.send

import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.awaitCancellation
import robotran.legofirmware.device.DatalogEntry
import robotran.programs.Program
import robotran.tower.ReceivedMessage
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareImage
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import robotran.tower.port.TowerPorts

internal val USB_TOWER = TowerDevice("usb", "LEGO USB Tower", TowerKind.USB)
internal val SERIAL_TOWER = TowerDevice("COM3", "COM3", TowerKind.SERIAL)

/** A machine to which towers can be plugged. [opened] has all ports that were opened, in order. */
internal class PluggedTowers(
    var devices: List<TowerDevice> = emptyList(),
    override val kinds: Set<TowerKind> = TowerKind.entries.toSet(),
) : TowerPorts {
    val opened = mutableListOf<SilentPort>()

    /** What the platform's dialog returns. */
    var chosen: TowerDevice? = null
    var failure: OpenFailure? = null

    /** The kinds that the platform was asked for. */
    val asked = mutableListOf<TowerKind>()

    override suspend fun available(): List<TowerDevice> = devices

    override suspend fun choose(kind: TowerKind): TowerDevice? {
        asked += kind
        return chosen
    }

    override suspend fun open(device: TowerDevice): OpenedTower {
        failure?.let { return OpenedTower.Failure(it) }
        val port = SilentPort(device)
        opened += port
        return OpenedTower.Success(port)
    }
}

/** A port over which nothing goes; [ScriptedRobot] answers in its place. */
internal class SilentPort(val device: TowerDevice) : TowerPort {
    override val kind: TowerKind = device.kind
    var isClosed = false
        private set

    override suspend fun send(bytes: ByteArray): Boolean = true

    override suspend fun receive(): ByteArray? = awaitCancellation()

    override suspend fun close() {
        isClosed = true
    }
}

/** A robot that does what a test wants. */
internal class ScriptedRobot : RobotLinks {
    var isTowerThere = true

    /** How often somebody has looked whether it is. */
    var looks = 0
        private set

    /** The answers to the next checks; a brick that answers once they are used up. */
    val checks = ArrayDeque<TowerError>()

    /** The results of the next transfers; complete once they are used up. */
    val transfers = ArrayDeque<TransferResult>()

    /** If not null, transfers wait for it before they end. */
    var hold: CompletableDeferred<Unit>? = null
    val programs = mutableListOf<ByteArray>()

    /** The slots of LEGO's firmware that programs were sent to, and whether all were emptied before. */
    val slots = mutableListOf<Pair<Int, Boolean>>()
    val firmwares = mutableListOf<FirmwareImage>()

    var datalog: TowerResult<List<DatalogEntry>> = TowerResult.Success(emptyList())

    /** What the robot sends while it is watched; then the tower is gone. */
    var messages: List<ReceivedMessage> = emptyList()

    override fun over(port: TowerPort): RobotLink = object : RobotLink {
        override suspend fun isTowerThere(): Boolean = isTowerThere.also { looks++ }

        override suspend fun check(program: BuiltProgram): TowerError? = checks.removeFirstOrNull()

        override suspend fun sendProgram(
            program: BuiltProgram.Lejos,
            progress: (TransferProgress) -> Unit,
        ): TransferResult {
            programs += program.image
            return transfer(program.image, progress)
        }

        override suspend fun sendProgram(
            program: BuiltProgram.Lego,
            slot: Int,
            emptiesOthers: Boolean,
            progress: (TransferProgress) -> Unit,
        ): TransferResult {
            slots += slot to emptiesOthers
            return transfer(ByteArray(program.image.codeSize), progress)
        }

        override suspend fun readDatalog(progress: (TransferProgress) -> Unit): TowerResult<List<DatalogEntry>> {
            progress(TransferProgress(confirmedBlocks = 1, totalBlocks = 2, repeats = 0, secondsLeft = 1))
            return datalog
        }

        override suspend fun sendFirmware(
            firmware: FirmwareImage,
            progress: (TransferProgress) -> Unit,
        ): TransferResult {
            firmwares += firmware
            return transfer(firmware.bytes, progress)
        }

        override suspend fun watch(receive: (ReceivedMessage) -> Unit) = messages.forEach(receive)
    }

    private suspend fun transfer(bytes: ByteArray, progress: (TransferProgress) -> Unit): TransferResult {
        progress(TransferProgress(confirmedBlocks = 3, totalBlocks = 12, repeats = 1, secondsLeft = 20))
        hold?.await()
        return transfers.removeFirstOrNull() ?: TransferResult.Success(bytes.size, repeats = 0)
    }
}

/** Makes of each program the image of its text, or what [result] says. */
internal class TextImages : ImageBuilder {
    var result: ProgramImageResult? = null

    override suspend fun build(program: Program): ProgramImageResult = result ?: ProgramImageResult.Success(
        BuiltProgram.Lejos(program.files.first().text.encodeToByteArray(), maxBytes = 10_000),
    )
}

/** A firmware file that a brick would accept, though it could not run it. Its header tells whose it is. */
internal fun firmwareFile(header: String = "made up"): ByteArray {
    val text = "Do you byte, when I knock?".encodeToByteArray()
    val records =
        listOf(record(0, 0, header.encodeToByteArray()), record(1, 0x8000, text), record(9, 0x8000, ByteArray(0)))
    return records.joinToString("\n").encodeToByteArray()
}

private fun record(type: Int, address: Int, data: ByteArray): String {
    val counted = listOf(data.size + 3, address shr 8, address and 0xFF) + data.map { it.toInt() and 0xFF }
    return "S$type" +
        (counted + (255 - counted.sum() % 256)).joinToString("") { it.toString(16).uppercase().padStart(2, '0') }
}
