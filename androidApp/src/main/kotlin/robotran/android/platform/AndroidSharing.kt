package robotran.android.platform

import android.content.ClipData
import android.content.ClipboardManager
import android.content.Context
import android.content.Intent
import androidx.core.content.FileProvider
import robotran.documents.FileKind
import robotran.workshop.platform.Sharing
import java.io.File
import java.io.IOException

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

    override val canShareFiles: Boolean = true

    /** The file stays in the app's cache until the next one, since the other app reads it whenever it wants. */
    override suspend fun shareFile(name: String, kind: FileKind, bytes: ByteArray): Boolean = handOver {
        val folder = File(context.cacheDir, "shared")
        folder.deleteRecursively()
        folder.mkdirs()
        val file = File(folder, name)
        file.writeBytes(bytes)
        val address = FileProvider.getUriForFile(context, "${context.packageName}.photos", file)
        val message = Intent(Intent.ACTION_SEND).setType(kind.mimeType).putExtra(Intent.EXTRA_STREAM, address)
        message.clipData = ClipData.newRawUri(name, address)
        message.addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION)
        context.startActivity(Intent.createChooser(message, null).addFlags(Intent.FLAG_ACTIVITY_NEW_TASK))
    }

    /** Android throws if the text exceeds the size limit between apps. */
    private inline fun handOver(action: () -> Unit): Boolean = try {
        action()
        true
    } catch (_: RuntimeException) {
        false
    } catch (_: IOException) {
        false
    }
}
