package robotran.android.tower

import android.content.Context
import android.content.pm.PackageManager
import android.hardware.usb.UsbConstants
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbEndpoint
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbManager
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPorts
import robotran.tower.port.UsbTower
import robotran.tower.port.UsbTowerRequest

/**
 * LEGO's USB towers, on devices that can be a USB host. Android asks the user once for each tower that is plugged in.
 *
 * Serial towers need a driver for their USB adapter in the app: Android has none, and no library on Maven Central is
 * fit for it, see `docs/android.md`.
 */
internal class AndroidTowers(private val context: Context) : TowerPorts {
    private val manager: UsbManager? =
        context.takeIf { it.packageManager.hasSystemFeature(PackageManager.FEATURE_USB_HOST) }
            ?.getSystemService(UsbManager::class.java)

    override val kinds: Set<TowerKind> = if (manager == null) emptySet() else setOf(TowerKind.USB)

    override suspend fun available(): List<TowerDevice> = plugged().filter(::isAllowed).map(::deviceOf)

    override suspend fun choose(kind: TowerKind): TowerDevice? {
        val usb = manager ?: return null
        if (kind != TowerKind.USB) return null
        val tower = plugged().firstOrNull() ?: return null
        if (!isAllowed(tower)) askForPermission(context, usb, tower)
        return deviceOf(tower).takeIf { isAllowed(tower) }
    }

    override suspend fun open(device: TowerDevice): OpenedTower {
        val tower = plugged().firstOrNull { it.deviceName == device.id } ?: return failed(OpenFailure.GONE)
        if (!isAllowed(tower)) return failed(OpenFailure.NOT_ALLOWED)
        val connection = manager?.openDevice(tower) ?: return failed(OpenFailure.BUSY)
        val port = prepare(connection, tower)
        if (port == null) connection.close()
        return port?.let { OpenedTower.Success(it) } ?: failed(OpenFailure.HELD_BY_DRIVER)
    }

    /** Null if something else holds the tower. */
    private fun prepare(connection: UsbDeviceConnection, tower: UsbDevice): UsbTowerPort? {
        val line = tower.interfaces().firstOrNull() ?: return null
        val input = line.endpoint(UsbConstants.USB_DIR_IN) ?: return null
        val output = line.endpoint(UsbConstants.USB_DIR_OUT) ?: return null
        if (!UsbTower.START.all { ask(connection, it) }) return null
        // Takes it from a driver of the system, too.
        if (!connection.claimInterface(line, true)) return null
        if (!ask(connection, UsbTower.FLUSH)) return null
        return UsbTowerPort(connection, line, input, output)
    }

    private fun ask(connection: UsbDeviceConnection, request: UsbTowerRequest): Boolean {
        val answer = ByteArray(request.answerBytes)
        val type = UsbConstants.USB_DIR_IN or UsbConstants.USB_TYPE_VENDOR
        return connection.controlTransfer(type, request.number, request.value, 0, answer, answer.size, TIMEOUT) >= 0
    }

    private fun plugged(): List<UsbDevice> = manager?.deviceList.orEmpty().values.filter {
        it.vendorId == UsbTower.VENDOR && it.productId == UsbTower.PRODUCT
    }

    private fun isAllowed(tower: UsbDevice) = manager?.hasPermission(tower) == true

    private fun deviceOf(tower: UsbDevice) = TowerDevice(tower.deviceName, tower.productName.orEmpty(), TowerKind.USB)

    private fun failed(reason: OpenFailure) = OpenedTower.Failure(reason)

    private companion object {
        /** Milliseconds. */
        const val TIMEOUT = 1_000
    }
}

private fun UsbDevice.interfaces(): List<UsbInterface> = (0..<interfaceCount).map(::getInterface)

private fun UsbInterface.endpoint(direction: Int): UsbEndpoint? =
    (0..<endpointCount).map(::getEndpoint).firstOrNull { it.direction == direction }
