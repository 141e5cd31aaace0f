package robotran.android.platform

import android.content.ClipData
import android.content.ClipboardManager
import android.content.Context
import android.content.Intent
import kotlinx.coroutines.Dispatchers
import robotran.android.sound.audioTrackSpeaker
import robotran.ui.platform.Arrivals
import robotran.ui.platform.FolderWorkStore
import robotran.ui.platform.JavaClock
import robotran.ui.platform.Platform
import robotran.ui.platform.Sharing
import robotran.ui.platform.WallClock
import robotran.ui.platform.WorkStore
import robotran.ui.sound.LoudSpeaker
import kotlin.coroutines.CoroutineContext
import kotlin.coroutines.EmptyCoroutineContext

/** What Android offers to the app; work is kept among the app's own files. */
class AndroidPlatform(
    context: Context,
) : Platform {
    override val speaker: LoudSpeaker = audioTrackSpeaker()
    override val store: WorkStore = FolderWorkStore(context.filesDir.toPath().resolve("work"), EmptyCoroutineContext)
    override val files = AndroidFileDesk(context.contentResolver)
    override val sharing: Sharing = AndroidSharing(context)
    override val clock: WallClock = JavaClock
    override val arrivals = Arrivals()
    override val background: CoroutineContext = Dispatchers.Default
}

private class AndroidSharing(
    private val context: Context,
) : Sharing {
    override val hasShareSheet: Boolean = true

    override suspend fun copy(text: String): Boolean {
        val clipboard = context.getSystemService(ClipboardManager::class.java) ?: return false
        clipboard.setPrimaryClip(ClipData.newPlainText("Robotran", text))
        return true
    }

    override suspend fun share(text: String): Boolean {
        val message = Intent(Intent.ACTION_SEND).setType("text/plain").putExtra(Intent.EXTRA_TEXT, text)
        context.startActivity(Intent.createChooser(message, null).addFlags(Intent.FLAG_ACTIVITY_NEW_TASK))
        return true
    }
}
