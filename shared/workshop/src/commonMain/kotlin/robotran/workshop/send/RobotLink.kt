package robotran.workshop.send

import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.port.TowerPort
import robotran.workshop.state.FirmwareKind

/** An RCX at the other side of an open tower. Only one function may run at a time. */
interface RobotLink {
    /** Wakes the tower and asks whether a brick answers. Null if one does. */
    suspend fun check(): TowerError?

    /** Replaces the brick's program by [image]. If cancelled, the brick is left without a program. */
    suspend fun sendProgram(image: ByteArray, progress: (TransferProgress) -> Unit): TransferResult

    /** Replaces the brick's firmware by [file]. If cancelled, the brick is left without firmware. */
    suspend fun sendFirmware(file: ByteArray, progress: (TransferProgress) -> Unit): TransferResult

    /** Passes everything that the robot sends to [receive]; returns once the tower is gone. */
    suspend fun watch(receive: (ByteArray) -> Unit)
}

/** What is known of robots before one is reached. */
interface RobotLinks {
    fun over(port: TowerPort): RobotLink

    /** Tells what the firmware file [bytes] is. */
    fun recognise(bytes: ByteArray): FirmwareKind
}
