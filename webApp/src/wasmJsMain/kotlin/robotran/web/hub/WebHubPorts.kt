@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.hub

import kotlinx.coroutines.delay
import robotran.hublink.HubError
import robotran.hublink.HubKind
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.HubUuids
import robotran.hublink.connection.OpenedHub
import robotran.hublink.connection.PacketHub
import robotran.hublink.connection.SerialHub
import robotran.web.device.Outcome
import robotran.web.device.SeenDevices
import robotran.web.device.SerialPort
import robotran.web.device.UsbDevice
import robotran.web.device.browserSerial
import robotran.web.device.browserUsb
import robotran.web.device.outcome
import kotlin.time.Duration.Companion.milliseconds

/**
 * Hubs through Web Bluetooth, Web Serial and WebUSB, which Chromium's browsers have. The browser remembers which hubs at USB
 * the pupil has allowed; of those at Bluetooth the page knows only what was chosen since it was opened.
 */
internal class WebHubPorts : HubPorts {
    private val bluetooth = browserBluetooth()
    private val serial = browserSerial()
    private val usb = browserUsb()
    private val seen = SeenDevices()
    private var chosenByBluetooth: BluetoothDevice? = null

    override val transports: Set<HubTransport> = buildSet {
        if (bluetooth != null) add(HubTransport.BLUETOOTH)
        if (serial != null) add(HubTransport.USB_SERIAL)
        if (usb != null) add(HubTransport.USB_PACKETS)
    }

    override suspend fun available(): List<HubDevice> = buildList {
        chosenByBluetooth?.let { add(deviceOf(it)) }
        serial?.getPorts()?.outcome()?.value?.toList()?.filter(::isHub)?.forEach { add(deviceOf(it)) }
        usb?.getDevices()?.outcome()?.value?.toList()?.filter(::isHub)?.forEach { add(deviceOf(it)) }
    }

    override suspend fun choose(transport: HubTransport): ChosenHub = when (transport) {
        HubTransport.BLUETOOTH -> chosen(bluetooth?.requestDevice(HUBS)?.outcome(), HubError.BluetoothNotAllowed) {
            chosenByBluetooth = it
            deviceOf(it)
        }

        HubTransport.USB_SERIAL -> chosen(serial?.requestPort(serialHubs())?.outcome(), HubError.NotAllowed, ::deviceOf)

        HubTransport.USB_PACKETS -> chosen(usb?.requestDevice(usbHubs())?.outcome(), HubError.NotAllowed, ::deviceOf)
    }

    /** A dialog that was cancelled, or found nothing, ends with a NotFoundError; a policy that forbids it otherwise. */
    private fun <T : JsAny?> chosen(
        asked: Outcome<T>?,
        refusal: HubError,
        deviceOf: (T & Any) -> HubDevice,
    ): ChosenHub = when {
        asked?.error in REFUSALS -> ChosenHub.Refused(refusal)
        else -> ChosenHub.of(asked?.value?.let(deviceOf))
    }

    override suspend fun open(device: HubDevice): OpenedHub {
        val found = seen.named(device.id) ?: return OpenedHub.Failure(HubError.OutOfReach)
        return when (device.transport) {
            HubTransport.BLUETOOTH -> BluetoothHub.open(found.unsafeCast())
            HubTransport.USB_SERIAL -> openSerial(found.unsafeCast())
            HubTransport.USB_PACKETS -> openUsb(found.unsafeCast())
        }
    }

    private suspend fun openSerial(port: SerialPort): OpenedHub {
        var error = openOnce(port)
        // Right after a hub is plugged in, the system may still be giving the user the right to it.
        for (attempt in 1..TRIES) {
            if (error == null) break
            delay(PAUSE)
            error = openOnce(port)
        }
        return error?.let { OpenedHub.Failure(it) } ?: OpenedHub.Success(SerialHub(SerialHubPort(port)))
    }

    private suspend fun openOnce(port: SerialPort): HubError? {
        port.open(hubLine()).outcome().error?.let { return errorOf(it) }
        port.setSignals(readyToHear()).outcome().error?.let { error ->
            port.close().outcome()
            return errorOf(error)
        }
        return null
    }

    private suspend fun openUsb(device: UsbDevice): OpenedHub {
        device.open().outcome().error?.let { return OpenedHub.Failure(errorOf(it)) }
        val opened = claim(device)
        if (opened is OpenedHub.Failure) device.close().outcome()
        return opened
    }

    private suspend fun claim(device: UsbDevice): OpenedHub {
        device.selectConfiguration(CONFIGURATION).outcome().error?.let { return OpenedHub.Failure(errorOf(it)) }
        val found = pybricksInterface(device) ?: return OpenedHub.Failure(HubError.LegoFirmware)
        device.claimInterface(found.number).outcome().error?.let { return OpenedHub.Failure(HubError.Taken) }
        return OpenedHub.Success(PacketHub(UsbHubPort(device, found)))
    }

    private fun isHub(port: SerialPort): Boolean = port.getInfo().let { info ->
        info.usbVendorId == HubKind.USB_VENDOR && info.usbProductId?.let(HubKind::ofUsbProduct) != null
    }

    private fun isHub(device: UsbDevice): Boolean =
        device.vendorId == HubKind.USB_VENDOR && HubKind.ofUsbProduct(device.productId) != null

    private fun deviceOf(device: BluetoothDevice) =
        HubDevice(seen.idOf(device), device.name.orEmpty(), HubTransport.BLUETOOTH)

    private fun deviceOf(port: SerialPort): HubDevice {
        val kind = port.getInfo().usbProductId?.let(HubKind::ofUsbProduct)
        return HubDevice(seen.idOf(port), kind?.productName.orEmpty(), HubTransport.USB_SERIAL)
    }

    private fun deviceOf(device: UsbDevice): HubDevice {
        val name = device.productName ?: HubKind.ofUsbProduct(device.productId)?.productName
        return HubDevice(seen.idOf(device), name.orEmpty(), HubTransport.USB_PACKETS)
    }

    private companion object {
        const val CONFIGURATION = 1
        const val TRIES = 4
        val PAUSE = 100.milliseconds

        /** Hubs with LEGO's firmware, too: who chooses one is told what it lacks. */
        val HUBS = hubsWith(
            services = "${HubUuids.SERVICE},${HubUuids.LEGO_SERVICE}",
            also = "${HubUuids.SERVICE},${HubUuids.DEVICE_INFORMATION}",
        )
    }
}

/** What the browser says where a policy, or the user for good, forbids to use a device. */
private val REFUSALS = setOf("SecurityError", "NotAllowedError")

/** What a call of a serial port or a USB device was rejected with. */
private fun errorOf(error: String): HubError = when (error) {
    "NotFoundError" -> HubError.OutOfReach
    in REFUSALS -> HubError.NotAllowed

    // NetworkError: the system refuses it. InvalidStateError: this page has it open.
    else -> HubError.Taken
}
