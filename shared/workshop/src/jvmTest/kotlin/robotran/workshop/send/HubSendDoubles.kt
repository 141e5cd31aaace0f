package robotran.workshop.send

import kotlinx.coroutines.runBlocking
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.OpenedHub
import robotran.hublink.simulated.SimulatedBluetooth
import robotran.hublink.simulated.SimulatedHub
import robotran.hublink.simulated.WireFaults
import robotran.mpycompiler.JvmMpyCompiler
import robotran.mpycompiler.MpyCompiler
import robotran.mpycompiler.MpyResult

internal val MY_HUB = HubDevice("mine", "Ada", HubTransport.BLUETOOTH)
internal val OTHER_HUB = HubDevice("other", "Grace", HubTransport.BLUETOOTH)

/** A machine with Bluetooth near [hub]. */
internal class NearHubs(
    private val hub: SimulatedHub,
    var devices: List<HubDevice> = listOf(MY_HUB),
    override val transports: Set<HubTransport> = setOf(HubTransport.BLUETOOTH),
) : HubPorts {
    /** What the platform's dialog returns. */
    var chosen: ChosenHub = ChosenHub.Chosen(MY_HUB)

    /** Why hubs cannot be opened. */
    var failure: HubError? = null

    /** What goes wrong on the next connection. */
    var faults = WireFaults()

    val opened = mutableListOf<HubDevice>()
    var connection: SimulatedBluetooth? = null

    override suspend fun available(): List<HubDevice> = devices

    override suspend fun choose(transport: HubTransport): ChosenHub = chosen

    override suspend fun open(device: HubDevice): OpenedHub {
        opened += device
        failure?.let { return OpenedHub.Failure(it) }
        return OpenedHub.Success(SimulatedBluetooth(hub, faults).also { connection = it })
    }
}

/** The real compiler, in the time of the test. */
internal object CompilerInTest : MpyCompiler {
    var lastSource = ""
        private set

    override suspend fun compile(fileName: String, source: String): MpyResult {
        lastSource = source
        return runBlocking { JvmMpyCompiler().compile(fileName, source) }
    }
}
