package robotran.android

import android.content.Context
import android.content.res.Configuration
import androidx.compose.ui.text.font.createFontFamilyResolver
import kotlinx.coroutines.Dispatchers
import robotran.android.R
import robotran.android.hub.AndroidHubPorts
import robotran.android.hub.BluetoothPermissions
import robotran.android.microbit.AndroidMicrobitPorts
import robotran.android.platform.AndroidFilePicker
import robotran.android.platform.AndroidMotion
import robotran.android.platform.AndroidPhotoReader
import robotran.android.platform.AndroidPhotos
import robotran.android.platform.AndroidPosters
import robotran.android.platform.AndroidSharing
import robotran.android.platform.ContentFiles
import robotran.android.platform.pixelsIn
import robotran.android.sound.audioTrackSpeaker
import robotran.android.tower.AndroidTowers
import robotran.hublink.connection.HubPorts
import robotran.microbitlink.dap.MicrobitPorts
import robotran.mpycompiler.JvmMpyCompiler
import robotran.mpycompiler.MpyCompiler
import robotran.simulation.picture.WorldPictures
import robotran.tower.port.TowerPorts
import robotran.ui.pictures.DrawnWorldPictures
import robotran.ui.platform.FolderKeyValueStore
import robotran.ui.platform.FolderOpeningMarks
import robotran.ui.platform.JavaClock
import robotran.workshop.platform.GradingThreads
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpeningMarks
import robotran.workshop.platform.PhotoReader
import robotran.workshop.platform.PictureQrScanner
import robotran.workshop.platform.Platform
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.Sharing
import robotran.workshop.platform.WallClock
import robotran.workshop.sound.LoudSpeaker
import java.util.Locale
import kotlin.coroutines.CoroutineContext
import kotlin.coroutines.EmptyCoroutineContext

/** Android's services for the app. Projects are saved in the app's private storage. */
class AndroidPlatform(private val context: Context) : Platform {
    override val pictures: WorldPictures = DrawnWorldPictures { createFontFamilyResolver(context) }
    override val posters = AndroidPosters(context.packageManager)
    override val openRequests = OpenRequests()
    override val speaker: LoudSpeaker = audioTrackSpeaker()
    override val store: KeyValueStore =
        FolderKeyValueStore(context.filesDir.toPath().resolve("work"), EmptyCoroutineContext)
    override val openingMarks: OpeningMarks = FolderOpeningMarks(context.filesDir.toPath().resolve("opening"))
    override val files = AndroidFilePicker(ContentFiles(context.contentResolver), openRequests, ::unreadable)
    override val sharing: Sharing = AndroidSharing(context)
    override val clock: WallClock = JavaClock
    override val towers: TowerPorts = AndroidTowers(context)
    val bluetooth = BluetoothPermissions(context)
    override val hubs: HubPorts = AndroidHubPorts(context, bluetooth)
    override val microbits: MicrobitPorts = AndroidMicrobitPorts(context)
    override val mpyCompiler: MpyCompiler = JvmMpyCompiler()
    override val pageAddress: String = context.getString(R.string.page_address)

    /** False for a Chromebook, and for a tablet in a case with a keyboard. */
    override val isForFingers: Boolean =
        context.resources.configuration.keyboard != Configuration.KEYBOARD_QWERTY
    override val photoReader: PhotoReader = AndroidPhotoReader
    val motion = AndroidMotion(context.contentResolver)
    override val prefersLessMotion: Boolean get() = motion.isReduced
    override val gradingWorkers: GradingWorkers = GradingThreads()
    val photos = AndroidPhotos(context)
    override val qrScanner: QrScanner = PictureQrScanner(files, Dispatchers.IO, photos, ::pixelsIn)
    override val background: CoroutineContext = Dispatchers.Default

    /** Uses the app's language, which may differ from the system's. */
    private fun unreadable(name: String): String {
        val configuration = Configuration(context.resources.configuration).apply { setLocale(Locale.getDefault()) }
        return context.createConfigurationContext(configuration).getString(R.string.unreadable_file, name)
    }
}
