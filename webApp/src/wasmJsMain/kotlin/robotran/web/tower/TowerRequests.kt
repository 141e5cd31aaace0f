@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.tower

import robotran.web.device.UsbDevice

/** The options of a tower's port. The browser's default buffer is smaller than the echo of a message. */
internal fun towerLine(): JsAny = js("({ baudRate: 2400, dataBits: 8, stopBits: 1, parity: 'odd', bufferSize: 65536 })")

internal fun onlyDevice(vendorId: Int, productId: Int): JsAny = js("({ filters: [{ vendorId, productId }] })")

internal fun vendorRequest(request: Int, value: Int): JsAny =
    js("({ requestType: 'vendor', recipient: 'device', request, value, index: 0 })")

/** The number of the endpoint of the first interface in [direction], `in` or `out`; 0 for none. */
internal fun endpointOf(device: UsbDevice, direction: String): Int = js(
    """(() => {
        const found = device.configuration.interfaces[0].alternate.endpoints.find((each) => each.direction === direction);
        return found ? found.endpointNumber : 0;
    })()""",
)
