package robotran.desktoptower

import com.fazecast.jSerialComm.SerialPort
import com.fazecast.jSerialComm.SerialPortInvalidPortException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPorts
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * The towers of a desktop machine: serial ports, and on Linux the USB tower through the file of the kernel's driver.
 * Windows and macOS have no such driver any more; there Chrome reaches the USB tower.
 *
 * @param devices the folder of device files.
 */
class DesktopTowerPorts(private val devices: Path = Path.of("/dev")) : TowerPorts {
    override val kinds: Set<TowerKind> =
        if (isLinux()) setOf(TowerKind.USB, TowerKind.SERIAL) else setOf(TowerKind.SERIAL)

    override suspend fun available(): List<TowerDevice> = withContext(Dispatchers.IO) { usbTowers() + serialPorts() }

    override suspend fun choose(kind: TowerKind): TowerDevice? = available().firstOrNull { it.kind == kind }

    /** Opens any port of the machine, also one that [available] does not list. */
    override suspend fun open(device: TowerDevice): OpenedTower = withContext(Dispatchers.IO) {
        when (device.kind) {
            TowerKind.USB -> openFile(Path.of(device.id))
            TowerKind.SERIAL -> openSerial(device.id)
        }
    }

    /** The device that a user names: `COM3`, `/dev/ttyUSB0` or `ttyUSB0`. */
    fun named(name: String): TowerDevice {
        val kind = if (USB_TOWER in name) TowerKind.USB else TowerKind.SERIAL
        val isShort = !isWindows() && !name.startsWith("/")
        return TowerDevice(if (isShort) devices.resolve(name).toString() else name, name, kind)
    }

    private fun usbTowers(): List<TowerDevice> {
        val folders = listOf(devices.resolve("usb"), devices).filter { it.isDirectory() }
        return folders.flatMap { it.listDirectoryEntries("$USB_TOWER*") }.sorted()
            .map { TowerDevice(it.toString(), it.name, TowerKind.USB) }
    }

    private fun serialPorts(): List<TowerDevice> = SerialPort.getCommPorts()
        .filterNot { isCallIn(it.systemPortName) }
        .sortedWith(compareBy({ unlikeliness(it) }, { it.systemPortName }))
        .map { TowerDevice(idOf(it), it.descriptivePortName.orEmpty(), TowerKind.SERIAL) }

    private fun openFile(path: Path): OpenedTower = when {
        !path.exists() -> failed(OpenFailure.GONE)
        !Files.isReadable(path) || !Files.isWritable(path) -> failed(OpenFailure.NOT_ALLOWED)
        else -> DeviceFileTower.open(path)?.let { OpenedTower.Success(it) } ?: failed(OpenFailure.BUSY)
    }

    private fun openSerial(path: String): OpenedTower {
        val port = try {
            SerialPort.getCommPort(path)
        } catch (_: SerialPortInvalidPortException) {
            return failed(OpenFailure.GONE)
        }
        val opened = SerialTower.open(port)
        return if (opened == null) failed(reasonOf(port, path)) else OpenedTower.Success(opened)
    }

    private fun reasonOf(port: SerialPort, path: String): OpenFailure = when {
        isWindows() -> when (port.lastErrorCode) {
            WINDOWS_NO_FILE -> OpenFailure.GONE
            else -> OpenFailure.BUSY
        }

        !Path.of(path).exists() -> OpenFailure.GONE
        !Files.isWritable(Path.of(path)) -> OpenFailure.NOT_ALLOWED
        else -> if (port.lastErrorCode in NO_DEVICE) OpenFailure.GONE else OpenFailure.BUSY
    }

    private fun failed(reason: OpenFailure) = OpenedTower.Failure(reason)

    private companion object {
        /** The file of the Linux kernel's driver `legousbtower`. */
        const val USB_TOWER = "legousbtower"
        const val WINDOWS_NO_FILE = 2

        /** EIO, ENXIO, ENODEV, ENOTTY: a file in `/dev` without a serial port behind it. */
        val NO_DEVICE = setOf(5, 6, 19, 25)

        fun system(): String = System.getProperty("os.name").lowercase()

        fun isLinux() = system().startsWith("linux")

        fun isWindows() = system().startsWith("windows")

        /** As users know it: `COM3` or `/dev/ttyUSB0`. */
        fun idOf(port: SerialPort): String = if (isWindows()) port.systemPortName else port.systemPortPath

        /** macOS has two files for each port; the one for incoming calls waits for a carrier. */
        fun isCallIn(name: String) = system().startsWith("mac") && name.startsWith("tty.")

        /** 0 for an adapter at a USB port, where a serial tower is today; 2 for what is hardly a tower. */
        fun unlikeliness(port: SerialPort): Int {
            val words = "${port.systemPortName} ${port.descriptivePortName}".lowercase()
            return when {
                listOf("bluetooth", "modem", "debug", "ttyacm", "rfcomm").any { it in words } -> 2
                "usb" in words || "serial" in words -> 0
                else -> 1
            }
        }
    }
}
