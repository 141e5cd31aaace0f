package robotran.android.hub

import android.annotation.SuppressLint
import android.bluetooth.BluetoothAdapter
import android.bluetooth.BluetoothManager
import android.bluetooth.le.ScanCallback
import android.bluetooth.le.ScanFilter
import android.bluetooth.le.ScanResult
import android.bluetooth.le.ScanSettings
import android.content.Context
import android.content.pm.PackageManager
import android.os.ParcelUuid
import android.os.SystemClock
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.delay
import kotlinx.coroutines.withTimeoutOrNull
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.HubUuids
import robotran.hublink.connection.OpenedHub
import java.util.UUID
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/** The hubs that show themselves by Bluetooth. A hub whose program runs does not. */
@SuppressLint("MissingPermission") // Each use looks at the permissions before.
internal class BluetoothHubs(private val context: Context, private val permissions: BluetoothPermissions) {
    val isThere: Boolean = context.packageManager.hasSystemFeature(PackageManager.FEATURE_BLUETOOTH_LE)

    private val adapter: BluetoothAdapter? get() = context.getSystemService(BluetoothManager::class.java)?.adapter

    /** The hubs of the last look. */
    private var found: List<HubDevice> = emptyList()
    private var lookedAt: Long? = null

    /** Those of a look a moment ago, or of a short one now; none without the permissions. */
    suspend fun seen(): List<HubDevice> {
        val last = lookedAt
        val isFresh = last != null && SystemClock.elapsedRealtime() - last < FRESH
        if (!isFresh && permissions.areGiven) look(SHORT_LOOK)
        return found
    }

    /** Asks for the permissions if they are missing, and looks. The only hub that is near, otherwise none. */
    suspend fun choose(): ChosenHub {
        if (!permissions.ask()) return ChosenHub.Refused(HubError.BluetoothNotAllowed)
        look(LONG_LOOK)
        return ChosenHub.of(found.singleOrNull())
    }

    suspend fun open(device: HubDevice): OpenedHub {
        val adapter = adapter
        if (!permissions.areGiven) return OpenedHub.Failure(HubError.BluetoothNotAllowed)
        if (adapter?.isEnabled != true) return OpenedHub.Failure(HubError.OutOfReach)
        return GattConnection.open(context, adapter.getRemoteDevice(device.id), device.name)
    }

    /** Looks for [time], or shorter once a hub was seen. */
    private suspend fun look(time: Duration) {
        val scanner = adapter?.takeIf { it.isEnabled }?.bluetoothLeScanner
        val seen = LinkedHashMap<String, HubDevice>()
        if (scanner != null) {
            val first = CompletableDeferred<Unit>()
            val callback = object : ScanCallback() {
                override fun onScanResult(type: Int, result: ScanResult) {
                    val address = result.device.address
                    val name = result.scanRecord?.deviceName ?: seen[address]?.name.orEmpty()
                    seen[address] = HubDevice(address, name, HubTransport.BLUETOOTH)
                    first.complete(Unit)
                }
            }
            try {
                scanner.startScan(FILTERS, FAST, callback)
                withTimeoutOrNull(time) {
                    first.await()
                    delay(OTHERS)
                }
            } finally {
                scanner.stopScan(callback)
            }
        }
        found = seen.values.toList()
        lookedAt = SystemClock.elapsedRealtime()
    }

    private companion object {
        val FILTERS = listOf(
            ScanFilter.Builder().setServiceUuid(ParcelUuid(UUID.fromString(HubUuids.SERVICE))).build(),
        )
        val FAST: ScanSettings = ScanSettings.Builder().setScanMode(ScanSettings.SCAN_MODE_LOW_LATENCY).build()
        val SHORT_LOOK = 3.seconds
        val LONG_LOOK = 8.seconds

        /** How long the hubs of others are looked for after the first. */
        val OTHERS = 2.seconds

        /** Milliseconds. Android allows five looks in half a minute. */
        const val FRESH = 10_000
    }
}
