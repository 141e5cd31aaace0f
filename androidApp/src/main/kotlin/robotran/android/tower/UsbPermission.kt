package robotran.android.tower

import android.app.PendingIntent
import android.content.BroadcastReceiver
import android.content.Context
import android.content.Intent
import android.content.IntentFilter
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbManager
import android.os.Build
import kotlinx.coroutines.suspendCancellableCoroutine
import kotlin.coroutines.resume

/**
 * Shows Android's question whether the app may use [device], and returns once the user has answered it. The answer is
 * not in what comes back, which other apps could send: ask [UsbManager.hasPermission].
 */
internal suspend fun askForPermission(context: Context, manager: UsbManager, device: UsbDevice) {
    suspendCancellableCoroutine { waiting ->
        val receiver = object : BroadcastReceiver() {
            override fun onReceive(receiving: Context, intent: Intent) {
                context.unregisterReceiver(this)
                if (waiting.isActive) waiting.resume(Unit)
            }
        }
        val filter = IntentFilter(ACTION)
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.TIRAMISU) {
            context.registerReceiver(receiver, filter, Context.RECEIVER_NOT_EXPORTED)
        } else {
            @Suppress("UnspecifiedRegisterReceiverFlag") // Does not exist yet.
            context.registerReceiver(receiver, filter)
        }
        waiting.invokeOnCancellation { context.unregisterReceiver(receiver) }
        val intent = Intent(ACTION).setPackage(context.packageName)
        // Android adds the device and the answer to it.
        val flags = if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.S) PendingIntent.FLAG_MUTABLE else 0
        manager.requestPermission(device, PendingIntent.getBroadcast(context, 0, intent, flags))
    }
}

private const val ACTION = "robotran.android.USB_PERMISSION"
