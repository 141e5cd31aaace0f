package robotran.workshop.send

import robotran.legofirmware.device.DatalogEntry
import robotran.tower.ReceivedMessage
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareImage
import robotran.tower.port.TowerPort

/** An RCX at the other side of an open tower. */
interface RobotLink {
    /** Whether there is a tower at the port, which the pupil has not chosen, as far as a short look tells. */
    suspend fun isTowerThere(): Boolean

    /** Asks whether a brick answers, and without deleting anything, whether it can run [program]. Null if so. */
    suspend fun check(program: BuiltProgram): TowerError?

    /** Replaces the brick's program by one for leJOS. If cancelled, the brick is left without a program. */
    suspend fun sendProgram(program: BuiltProgram.Lejos, progress: (TransferProgress) -> Unit): TransferResult

    /**
     * Replaces the program in [slot], from 1, by one for LEGO's firmware. If cancelled, the slot is left empty.
     *
     * @param emptiesOthers whether the programs in all slots are deleted before.
     */
    suspend fun sendProgram(
        program: BuiltProgram.Lego,
        slot: Int,
        emptiesOthers: Boolean,
        progress: (TransferProgress) -> Unit,
    ): TransferResult

    /** Reads the datalog of LEGO's firmware, which the brick keeps. */
    suspend fun readDatalog(progress: (TransferProgress) -> Unit): TowerResult<List<DatalogEntry>>

    /** Replaces the brick's firmware. If cancelled, the brick is left without firmware. */
    suspend fun sendFirmware(firmware: FirmwareImage, progress: (TransferProgress) -> Unit): TransferResult

    /** Passes everything that the robot sends to [receive]; returns once the tower is gone. */
    suspend fun watch(receive: (ReceivedMessage) -> Unit)
}

/** Makes a [RobotLink] of an open tower. */
fun interface RobotLinks {
    fun over(port: TowerPort): RobotLink
}
