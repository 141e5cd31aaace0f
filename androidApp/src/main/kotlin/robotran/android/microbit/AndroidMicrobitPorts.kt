package robotran.android.microbit

import android.content.Context
import android.content.pm.PackageManager
import android.hardware.usb.UsbConstants
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbManager
import robotran.android.tower.askForPermission
import robotran.android.usb.UsbStream
import robotran.android.usb.endpoint
import robotran.android.usb.interfaces
import robotran.microbitlink.BoardError
import robotran.microbitlink.dap.ChosenBoard
import robotran.microbitlink.dap.DapPort
import robotran.microbitlink.dap.MicrobitPorts
import robotran.microbitlink.dap.MicrobitUsb
import robotran.microbitlink.dap.OpenedBoard
import robotran.microbitlink.dap.PluggedBoard

/** Boards at the USB of a device that can be a host. Android asks the user once for each that is plugged in. */
internal class AndroidMicrobitPorts(private val context: Context) : MicrobitPorts {
    private val manager: UsbManager? by lazy(LazyThreadSafetyMode.NONE) {
        context.takeIf { it.packageManager.hasSystemFeature(PackageManager.FEATURE_USB_HOST) }
            ?.getSystemService(UsbManager::class.java)
    }

    override val canReach: Boolean get() = manager != null

    /** Those that the user has allowed. */
    override suspend fun available(): List<PluggedBoard> = plugged().filter(::isAllowed).map(::boardOf)

    /** Asks whether the app may use each board that is plugged in; which one is meant, the app asks itself. */
    override suspend fun choose(): ChosenBoard {
        val usb = manager ?: return ChosenBoard.None
        for (board in plugged().filterNot(::isAllowed)) askForPermission(context, usb, board)
        val boards = available()
        return when {
            boards.size > 1 -> ChosenBoard.Several(boards)
            boards.isNotEmpty() -> ChosenBoard.Chosen(boards.single())
            plugged().isEmpty() -> ChosenBoard.None
            else -> ChosenBoard.Refused(BoardError.NotAllowed)
        }
    }

    override suspend fun open(board: PluggedBoard): OpenedBoard {
        val device = plugged().firstOrNull { it.deviceName == board.id }
            ?: return OpenedBoard.Failure(BoardError.OutOfReach)
        if (!isAllowed(device)) return OpenedBoard.Failure(BoardError.NotAllowed)
        val line = dapInterface(device) ?: return OpenedBoard.Failure(BoardError.InterfaceTooOld)
        val connection = manager?.openDevice(device) ?: return OpenedBoard.Failure(BoardError.Taken)
        // Takes it from a driver of the system, too.
        if (!connection.claimInterface(line, true)) {
            connection.close()
            return OpenedBoard.Failure(BoardError.Taken)
        }
        return OpenedBoard.Success(portOf(connection, line))
    }

    /** Of a V2 the interface has endpoints, of a V1 none. */
    private fun portOf(connection: UsbDeviceConnection, line: UsbInterface): DapPort {
        val input = line.endpoint(UsbConstants.USB_DIR_IN)
        val output = line.endpoint(UsbConstants.USB_DIR_OUT)
        return if (input == null || output == null) {
            ControlPort(connection, line)
        } else {
            EndpointPort(UsbStream(connection, listOf(line), input, output))
        }
    }

    /** The interface that takes packets; null if the board's DAPLink is too old to have one. */
    private fun dapInterface(device: UsbDevice): UsbInterface? {
        val all = device.interfaces().filter { it.interfaceClass == MicrobitUsb.INTERFACE_CLASS }
        return all.firstOrNull { it.endpointCount > 0 } ?: all.firstOrNull()
    }

    private fun plugged(): List<UsbDevice> = manager?.deviceList.orEmpty().values.filter {
        it.vendorId == MicrobitUsb.VENDOR && it.productId == MicrobitUsb.PRODUCT
    }

    private fun isAllowed(board: UsbDevice) = manager?.hasPermission(board) == true

    private fun boardOf(board: UsbDevice) = PluggedBoard(board.deviceName, board.productName.orEmpty())
}
