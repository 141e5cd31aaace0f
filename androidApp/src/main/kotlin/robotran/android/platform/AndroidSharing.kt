package robotran.android.platform

import android.content.ClipData
import android.content.ClipboardManager
import android.content.Context
import android.content.Intent
import robotran.workshop.platform.Sharing

/** The clipboard and the share sheet. */
internal class AndroidSharing(private val context: Context) : Sharing {
    override val hasShareSheet: Boolean = true

    override suspend fun copy(text: String): Boolean = handOver {
        val clipboard = context.getSystemService(ClipboardManager::class.java) ?: return false
        clipboard.setPrimaryClip(ClipData.newPlainText("Robotran", text))
    }

    override suspend fun share(text: String): Boolean = handOver {
        val message = Intent(Intent.ACTION_SEND).setType("text/plain").putExtra(Intent.EXTRA_TEXT, text)
        context.startActivity(Intent.createChooser(message, null).addFlags(Intent.FLAG_ACTIVITY_NEW_TASK))
    }

    /** Android throws if the text exceeds the size limit between apps. */
    private inline fun handOver(action: () -> Unit): Boolean = try {
        action()
        true
    } catch (_: RuntimeException) {
        false
    }
}
