package robotran.hublink.hub

import kotlinx.coroutines.test.TestScope
import robotran.hublink.HubDescription
import robotran.hublink.HubResult
import robotran.hublink.HubVersion
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.PacketHub
import robotran.hublink.connection.SerialHub
import robotran.hublink.mpyOf
import robotran.hublink.program.HubProgram
import robotran.hublink.simulated.SimulatedBluetooth
import robotran.hublink.simulated.SimulatedHub
import robotran.hublink.simulated.SimulatedModel
import robotran.hublink.simulated.SimulatedPacketPort
import robotran.hublink.simulated.SimulatedProgram
import robotran.hublink.simulated.SimulatedSerialPort
import robotran.hublink.simulated.WireFaults
import kotlin.test.assertIs

/** A simulated hub at the end of a simulated wire, and what talks to it. */
internal class TestHub(
    scope: TestScope,
    transport: HubTransport = HubTransport.BLUETOOTH,
    model: SimulatedModel = modelFor(transport),
    faults: WireFaults = WireFaults(),
    program: SimulatedProgram = SimulatedProgram.printing("hello\r\n"),
) {
    val hub = SimulatedHub(scope.backgroundScope, model) { program }

    /** Breaks the connection. */
    val disconnect: () -> Unit

    val connection: HubConnection

    init {
        when (transport) {
            HubTransport.BLUETOOTH -> SimulatedBluetooth(hub, faults).let {
                connection = it
                disconnect = it::disconnect
            }

            HubTransport.USB_SERIAL -> SimulatedSerialPort(scope.backgroundScope, hub, faults).let {
                connection = SerialHub(it)
                disconnect = it::unplug
            }

            HubTransport.USB_PACKETS -> SimulatedPacketPort(scope.backgroundScope, hub, faults).let {
                connection = PacketHub(it)
                disconnect = it::unplug
            }
        }
    }

    val link = HubLink(connection, scope.backgroundScope)

    suspend fun open(): HubDescription = assertIs<HubResult.Success<HubDescription>>(link.open()).value

    companion object {
        fun modelFor(transport: HubTransport): SimulatedModel = when (transport) {
            HubTransport.BLUETOOTH -> SimulatedModel(messageBytes = 23)
            HubTransport.USB_SERIAL -> SimulatedModel(
                profile = HubVersion(1, 6),
                firmware = "4.1.0b2",
                messageBytes = 60,
            )
            HubTransport.USB_PACKETS -> SimulatedModel(pnpKind = 0xE2, messageBytes = 64)
        }
    }
}

/** A program of 365 bytes. */
internal val square: HubProgram get() = HubProgram(mpyOf("square.py"))
