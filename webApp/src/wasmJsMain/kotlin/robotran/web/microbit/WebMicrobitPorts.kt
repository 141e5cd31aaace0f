@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.microbit

import robotran.microbitlink.BoardError
import robotran.microbitlink.dap.ChosenBoard
import robotran.microbitlink.dap.DapPort
import robotran.microbitlink.dap.MicrobitPorts
import robotran.microbitlink.dap.MicrobitUsb
import robotran.microbitlink.dap.OpenedBoard
import robotran.microbitlink.dap.PluggedBoard
import robotran.web.device.SeenDevices
import robotran.web.device.UsbDevice
import robotran.web.device.browserUsb
import robotran.web.device.outcome

/** Boards through WebUSB, which Chromium's browsers have. They remember which boards the pupil has allowed. */
internal class WebMicrobitPorts : MicrobitPorts {
    private val usb = browserUsb()
    private val seen = SeenDevices()

    override val canReach: Boolean get() = usb != null

    override suspend fun available(): List<PluggedBoard> =
        usb?.getDevices()?.outcome()?.value?.toList().orEmpty().filter(::isBoard).map(::boardOf)

    override suspend fun choose(): ChosenBoard {
        val asked = usb?.requestDevice(boardsOf(MicrobitUsb.VENDOR, MicrobitUsb.PRODUCT))?.outcome()
        val error = asked?.error?.let(::errorOf)
        return when {
            error == BoardError.NotAllowed -> ChosenBoard.Refused(error)
            else -> asked?.value?.let { ChosenBoard.Chosen(boardOf(it)) } ?: ChosenBoard.None
        }
    }

    override suspend fun open(board: PluggedBoard): OpenedBoard {
        val device = seen.named(board.id)?.unsafeCast<UsbDevice>() ?: return OpenedBoard.Failure(BoardError.OutOfReach)
        device.open().outcome().error?.let { return OpenedBoard.Failure(errorOf(it)) }
        val opened = claim(device)
        if (opened is OpenedBoard.Failure) device.close().outcome()
        return opened
    }

    private suspend fun claim(device: UsbDevice): OpenedBoard {
        device.selectConfiguration(CONFIGURATION).outcome().error?.let { return OpenedBoard.Failure(errorOf(it)) }
        val found = dapInterface(device, MicrobitUsb.INTERFACE_CLASS)
            ?: return OpenedBoard.Failure(BoardError.InterfaceTooOld)
        device.claimInterface(found.number).outcome().error?.let { return OpenedBoard.Failure(BoardError.Taken) }
        val port: DapPort = if (found.input > 0) EndpointPort(device, found) else ControlPort(device, found.number)
        return OpenedBoard.Success(port)
    }

    private fun isBoard(device: UsbDevice) =
        device.vendorId == MicrobitUsb.VENDOR && device.productId == MicrobitUsb.PRODUCT

    private fun boardOf(device: UsbDevice) = PluggedBoard(seen.idOf(device), device.productName.orEmpty())

    private companion object {
        const val CONFIGURATION = 1
    }
}

/** What a call of a USB device was rejected with. */
private fun errorOf(error: String): BoardError = when (error) {
    "NotFoundError" -> BoardError.OutOfReach
    "SecurityError", "NotAllowedError" -> BoardError.NotAllowed

    // NetworkError: the system refuses it. InvalidStateError: this page has it open.
    else -> BoardError.Taken
}

private fun boardsOf(vendorId: Int, productId: Int): JsAny = js("({ filters: [{ vendorId, productId }] })")
