package robotran.workshop.send

import robotran.tower.BrickStatus
import robotran.tower.ReceivedMessage
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

    override suspend fun check(): TowerError? = when (val status = tower.status()) {
        // A brick that was heard at all is worth a transfer, which tries harder.
        is TowerResult.Failed -> status.error.takeIf { it != TowerError.BadConnection }

        is TowerResult.Success -> TowerError.NoLejos.takeIf { status.value is BrickStatus.LegoFirmware }
    }

    override suspend fun sendProgram(
        image: ProgramImageResult.Ready,
        progress: (TransferProgress) -> Unit,
    ): TransferResult = tower.sendProgram(image.image, image.maxBytes, progress)

    override suspend fun sendFirmware(firmware: FirmwareImage, progress: (TransferProgress) -> Unit): TransferResult =
        tower.sendFirmware(firmware, progress)

    override suspend fun watch(receive: (ReceivedMessage) -> Unit) = tower.messages().collect(receive)
}
