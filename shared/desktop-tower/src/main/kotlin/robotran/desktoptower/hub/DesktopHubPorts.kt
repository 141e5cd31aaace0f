package robotran.desktoptower.hub

import com.fazecast.jSerialComm.SerialPort
import com.fazecast.jSerialComm.SerialPortInvalidPortException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.withContext
import robotran.hublink.HubError
import robotran.hublink.HubKind
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.OpenedHub
import robotran.hublink.connection.SerialHub
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.time.Duration.Companion.milliseconds

/**
 * The hubs at USB of a desktop machine, with Pybricks 4.1: serial ports of LEGO's vendor number. The packets of 4.0 and
 * Bluetooth need a browser.
 */
class DesktopHubPorts : HubPorts {
    override val transports: Set<HubTransport> = setOf(HubTransport.USB_SERIAL)

    override suspend fun available(): List<HubDevice> = withContext(Dispatchers.IO) {
        SerialPort.getCommPorts()
            .filter { it.vendorID == HubKind.USB_VENDOR && HubKind.ofUsbProduct(it.productID) != null }
            // macOS has two files for each port; the one for incoming calls waits for a carrier.
            .filterNot { isMac && it.systemPortName.startsWith("tty.") }
            .sortedBy { it.systemPortName }
            .map { HubDevice(idOf(it), nameOf(it), HubTransport.USB_SERIAL) }
    }

    override suspend fun choose(transport: HubTransport): ChosenHub =
        ChosenHub.of(available().firstOrNull { it.transport == transport })

    /** Opens any serial port of the machine, also one that [available] does not list. */
    override suspend fun open(device: HubDevice): OpenedHub = withContext(Dispatchers.IO) {
        // Right after a hub is plugged in, the system may still be giving the user the right to it.
        repeat(TRIES) {
            val opened = openOnce(device.id)
            if (opened != OpenedHub.Failure(HubError.NotAllowed)) return@withContext opened
            delay(PAUSE)
        }
        OpenedHub.Failure(HubError.NotAllowed)
    }

    /** The hub that a user names: `COM3`, `/dev/ttyACM0` or `ttyACM0`. */
    fun named(name: String): HubDevice {
        val isShort = !isWindows && !name.startsWith("/")
        return HubDevice(if (isShort) "/dev/$name" else name, name, HubTransport.USB_SERIAL)
    }

    private fun openOnce(path: String): OpenedHub {
        val port = try {
            SerialPort.getCommPort(path)
        } catch (_: SerialPortInvalidPortException) {
            return OpenedHub.Failure(HubError.OutOfReach)
        }
        val opened = SerialPortOfHub.open(port) ?: return OpenedHub.Failure(errorOf(port, path))
        return OpenedHub.Success(SerialHub(opened))
    }

    private fun errorOf(port: SerialPort, path: String): HubError = when {
        isWindows -> if (port.lastErrorCode == WINDOWS_NO_FILE) HubError.OutOfReach else HubError.Taken
        !Path.of(path).exists() -> HubError.OutOfReach
        !Files.isWritable(Path.of(path)) -> HubError.NotAllowed
        else -> HubError.Taken
    }

    private companion object {
        const val TRIES = 5
        val PAUSE = 100.milliseconds
        const val WINDOWS_NO_FILE = 2
        val system: String = System.getProperty("os.name").lowercase()
        val isWindows = system.startsWith("windows")
        val isMac = system.startsWith("mac")

        /** As users know it: `COM3` or `/dev/ttyACM0`. */
        fun idOf(port: SerialPort): String = if (isWindows) port.systemPortName else port.systemPortPath

        fun nameOf(port: SerialPort): String =
            HubKind.ofUsbProduct(port.productID)?.productName ?: port.descriptivePortName.orEmpty()
    }
}
