package robotran.android.platform

import android.content.ActivityNotFoundException
import android.content.Context
import android.content.Intent
import android.net.Uri
import android.provider.MediaStore
import androidx.activity.ComponentActivity
import androidx.activity.result.ActivityResultLauncher
import androidx.activity.result.contract.ActivityResultContracts
import androidx.core.content.FileProvider
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.workshop.platform.PhotoResult
import robotran.workshop.platform.PhotoTaker
import java.io.File
import java.io.IOException

/**
 * Takes pictures with the camera app of the device, which needs no permission. A picture lies in the app's cache only
 * until it is read. The activity that shows the workshop attaches itself.
 */
class AndroidPhotos(private val context: Context) : PhotoTaker {
    private val folder = File(context.cacheDir, "photos")
    private var camera: ActivityResultLauncher<Uri>? = null
    private var asked: CompletableDeferred<Boolean>? = null

    override val isThere: Boolean
        get() = Intent(MediaStore.ACTION_IMAGE_CAPTURE).resolveActivity(context.packageManager) != null

    /** Must be called in `onCreate`. */
    fun attachTo(activity: ComponentActivity) {
        camera = activity.registerForActivityResult(ActivityResultContracts.TakePicture()) { isTaken ->
            // Nobody waits any more if the process has ended behind the camera.
            if (asked?.complete(isTaken) != true) folder.deleteRecursively()
        }
    }

    override suspend fun take(): PhotoResult {
        asked?.complete(false)
        val answer = CompletableDeferred<Boolean>()
        asked = answer
        val file = File(folder, "code.jpg")
        try {
            folder.mkdirs()
            camera?.launch(FileProvider.getUriForFile(context, "${context.packageName}.photos", file))
                ?: return PhotoResult.NoCamera
            if (!answer.await()) return PhotoResult.Cancelled
            return PhotoResult.Taken(withContext(Dispatchers.IO) { file.readBytes() })
        } catch (_: ActivityNotFoundException) {
            return PhotoResult.NoCamera
        } catch (_: SecurityException) {
            return PhotoResult.NoCamera
        } catch (_: IOException) {
            return PhotoResult.Cancelled
        } finally {
            if (asked === answer) {
                asked = null
                folder.deleteRecursively()
            }
        }
    }
}
