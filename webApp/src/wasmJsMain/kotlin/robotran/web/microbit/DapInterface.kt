@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.microbit

import robotran.web.device.UsbDevice

/** The interface of a board that takes packets. Its endpoints are 0 if it has none, as that of a V1. */
internal external interface DapInterface : JsAny {
    val number: Int
    val input: Int
    val output: Int
}

/** Of the interfaces of [device] with the class [wanted], one with endpoints, or else the first; null for none. */
internal fun dapInterface(device: UsbDevice, wanted: Int): DapInterface? = js(
    """(() => {
        const all = (device.configuration ? device.configuration.interfaces : [])
            .filter(({ alternate }) => alternate.interfaceClass === wanted)
            .map(({ interfaceNumber, alternate }) => {
                const endpoint = (direction) => alternate.endpoints.find((each) => each.direction === direction);
                const [input, output] = [endpoint('in'), endpoint('out')];
                const both = input && output;
                return { number: interfaceNumber, input: both ? input.endpointNumber : 0, output: both ? output.endpointNumber : 0 };
            });
        return all.find((each) => each.input > 0) || all[0] || null;
    })()""",
)
