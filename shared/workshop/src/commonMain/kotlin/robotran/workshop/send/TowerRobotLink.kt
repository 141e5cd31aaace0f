package robotran.workshop.send

import robotran.legofirmware.device.DatalogEntry
import robotran.legofirmware.image.FirmwareTarget
import robotran.tower.BrickStatus
import robotran.tower.LegoLimits
import robotran.tower.ReceivedMessage
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareImage
import robotran.tower.port.TowerPort
import robotran.tower.rcx.RcxTower

/** The robot in sight of the tower at [port]. */
internal class TowerRobotLink(port: TowerPort) : RobotLink {
    private val tower = RcxTower(port)

    override suspend fun isTowerThere(): Boolean = tower.isThere()

    override suspend fun check(program: BuiltProgram): TowerError? = when (val status = tower.status()) {
        // A brick that was heard at all is worth a transfer, which tries harder.
        is TowerResult.Failure -> status.error.takeIf { it != TowerError.BadConnection }

        is TowerResult.Success -> when (program) {
            is BuiltProgram.Lejos -> missingLejos(status.value)
            is BuiltProgram.Lego -> missingLego(status.value, program.image.target)
        }
    }

    /** Only the download itself tells leJOS from no firmware. */
    private fun missingLejos(status: BrickStatus): TowerError? =
        (status as? BrickStatus.LegoFirmware)?.let { TowerError.NoLejos(it.firmware) }

    private fun missingLego(status: BrickStatus, target: FirmwareTarget): TowerError? = when (status) {
        is BrickStatus.LegoFirmware -> TowerError.LegoFirmwareTooOld(status.firmware)
            .takeIf { target == FirmwareTarget.RCX2 && status.firmware < LegoLimits.VERSION_2 }

        is BrickStatus.LejosOrNoFirmware, BrickStatus.Unknown -> TowerError.NoLegoFirmware
    }

    override suspend fun sendProgram(
        program: BuiltProgram.Lejos,
        progress: (TransferProgress) -> Unit,
    ): TransferResult = tower.sendProgram(program.image, program.maxBytes, progress)

    override suspend fun sendProgram(
        program: BuiltProgram.Lego,
        slot: Int,
        emptiesOthers: Boolean,
        progress: (TransferProgress) -> Unit,
    ): TransferResult {
        if (emptiesOthers) {
            for (other in 1..LegoLimits.SLOTS) {
                val deleted = tower.deleteLegoProgram(other)
                if (deleted is TowerResult.Failure) return TransferResult.Failure(deleted.error, Remains.UNKNOWN)
            }
        }
        return tower.sendLegoProgram(slot, program.image, progress)
    }

    override suspend fun readDatalog(progress: (TransferProgress) -> Unit): TowerResult<List<DatalogEntry>> =
        tower.readLegoDatalog(progress)

    override suspend fun sendFirmware(firmware: FirmwareImage, progress: (TransferProgress) -> Unit): TransferResult =
        tower.sendFirmware(firmware, progress)

    override suspend fun watch(receive: (ReceivedMessage) -> Unit) = tower.messages().collect(receive)
}
