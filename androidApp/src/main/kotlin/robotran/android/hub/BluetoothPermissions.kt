package robotran.android.hub

import android.Manifest
import android.content.Context
import android.content.pm.PackageManager
import android.os.Build
import androidx.activity.ComponentActivity
import androidx.activity.result.ActivityResultLauncher
import androidx.activity.result.contract.ActivityResultContracts
import kotlinx.coroutines.CompletableDeferred

/**
 * What the user has to allow before hubs are found by Bluetooth. Before Android 12 that is the permission for the place,
 * which Robotran does not look at. The activity that shows the workshop attaches itself.
 */
class BluetoothPermissions(private val context: Context) {
    private var question: ActivityResultLauncher<Array<String>>? = null
    private var asked: CompletableDeferred<Unit>? = null

    val areGiven: Boolean
        get() = NEEDED.all { context.checkSelfPermission(it) == PackageManager.PERMISSION_GRANTED }

    /** Must be called in `onCreate`. */
    fun attachTo(activity: ComponentActivity) {
        question = activity.registerForActivityResult(ActivityResultContracts.RequestMultiplePermissions()) {
            asked?.complete(Unit)
        }
    }

    /** Asks the user unless it is allowed; whether it is then. */
    suspend fun ask(): Boolean {
        val question = question
        if (areGiven || question == null) return areGiven
        asked?.complete(Unit)
        val answer = CompletableDeferred<Unit>()
        asked = answer
        question.launch(NEEDED)
        answer.await()
        return areGiven
    }

    private companion object {
        val NEEDED: Array<String> = if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.S) {
            arrayOf(Manifest.permission.BLUETOOTH_SCAN, Manifest.permission.BLUETOOTH_CONNECT)
        } else {
            arrayOf(Manifest.permission.ACCESS_FINE_LOCATION)
        }
    }
}
