@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.tower

import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPorts
import robotran.tower.port.UsbTower
import robotran.tower.port.UsbTowerRequest
import robotran.web.device.SeenDevices
import robotran.web.device.SerialPort
import robotran.web.device.UsbDevice
import robotran.web.device.browserSerial
import robotran.web.device.browserUsb
import robotran.web.device.outcome

/**
 * Towers through Web Serial and WebUSB, which Chromium's browsers have. The browser remembers which ones the pupil has
 * allowed; only the first time it asks.
 */
internal class WebTowers : TowerPorts {
    private val serial = browserSerial()
    private val usb = browserUsb()

    private val seen = SeenDevices()

    override val kinds: Set<TowerKind> = buildSet {
        if (serial != null) add(TowerKind.SERIAL)
        if (usb != null) add(TowerKind.USB)
    }

    override suspend fun available(): List<TowerDevice> = buildList {
        usb?.getDevices()?.outcome()?.value?.toList()?.filter(::isTower)?.forEach { add(deviceOf(it)) }
        serial?.getPorts()?.outcome()?.value?.toList()?.forEach { add(deviceOf(it)) }
    }

    override suspend fun choose(kind: TowerKind): TowerDevice? = when (kind) {
        TowerKind.SERIAL -> serial?.requestPort()?.outcome()?.value?.let(::deviceOf)

        TowerKind.USB -> {
            val request = usb?.requestDevice(onlyDevice(UsbTower.VENDOR, UsbTower.PRODUCT))
            request?.outcome()?.value?.let(::deviceOf)
        }
    }

    override suspend fun open(device: TowerDevice): OpenedTower {
        val found = seen.named(device.id) ?: return OpenedTower.Failure(OpenFailure.GONE)
        return when (device.kind) {
            TowerKind.SERIAL -> openSerial(found.unsafeCast())
            TowerKind.USB -> openUsb(found.unsafeCast())
        }
    }

    private suspend fun openSerial(port: SerialPort): OpenedTower {
        val failure = port.open(towerLine()).outcome().error?.let(::serialFailure)
        return if (failure == null) OpenedTower.Success(WebSerialPort(port)) else OpenedTower.Failure(failure)
    }

    private suspend fun openUsb(device: UsbDevice): OpenedTower {
        val failure = prepare(device) ?: return OpenedTower.Success(WebUsbPort(device))
        if (device.opened) device.close().outcome()
        return OpenedTower.Failure(failure)
    }

    /** Null if the tower is ready. */
    private suspend fun prepare(device: UsbDevice): OpenFailure? {
        device.open().outcome().error?.let { return usbFailure(it) }
        for (request in UsbTower.START) ask(device, request)?.let { return it }
        device.selectConfiguration(UsbTower.CONFIGURATION).outcome().error?.let { return usbFailure(it) }
        device.claimInterface(UsbTower.INTERFACE).outcome().error?.let { return claimFailure(it) }
        return ask(device, UsbTower.FLUSH)
    }

    private suspend fun ask(device: UsbDevice, request: UsbTowerRequest): OpenFailure? {
        val setup = vendorRequest(request.number, request.value)
        return device.controlTransferIn(setup, request.answerBytes).outcome().error?.let(::usbFailure)
    }

    private fun isTower(device: UsbDevice) = device.vendorId == UsbTower.VENDOR && device.productId == UsbTower.PRODUCT

    private fun deviceOf(port: SerialPort): TowerDevice {
        val info = port.getInfo()
        val name = listOfNotNull(info.usbVendorId, info.usbProductId).joinToString(":") {
            it.toString(HEX).padStart(4, '0')
        }
        return TowerDevice(seen.idOf(port), name, TowerKind.SERIAL)
    }

    private fun deviceOf(device: UsbDevice) =
        TowerDevice(seen.idOf(device), device.productName.orEmpty(), TowerKind.USB)

    private companion object {
        const val HEX = 16
    }
}

/** Why `open` of a serial port was rejected with [error]. */
private fun serialFailure(error: String): OpenFailure = when (error) {
    "NotFoundError" -> OpenFailure.GONE
    "SecurityError", "NotAllowedError" -> OpenFailure.NOT_ALLOWED

    // NetworkError: the system refuses the port. InvalidStateError: this page has it open.
    else -> OpenFailure.BUSY
}

/** Why a call of a USB device was rejected with [error]. */
private fun usbFailure(error: String): OpenFailure = when (error) {
    "NotFoundError", "NetworkError" -> OpenFailure.GONE

    // Chromium says so of a device whose driver, or whose rights on Linux, keep it from the browser.
    "SecurityError" -> OpenFailure.HELD_BY_DRIVER
    "NotAllowedError" -> OpenFailure.NOT_ALLOWED
    else -> OpenFailure.BUSY
}

private fun claimFailure(error: String): OpenFailure =
    if (error == "NotFoundError") OpenFailure.GONE else OpenFailure.HELD_BY_DRIVER
