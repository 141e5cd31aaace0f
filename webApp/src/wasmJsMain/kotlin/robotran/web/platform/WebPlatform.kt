@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.await
import robotran.documents.FileKind
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.NoHubPorts
import robotran.microbitlink.dap.MicrobitPorts
import robotran.microbitlink.dap.NoMicrobitPorts
import robotran.mpycompiler.MpyCompiler
import robotran.projects.isLink
import robotran.simulation.picture.WorldPictures
import robotran.tower.port.NoTowerPorts
import robotran.tower.port.TowerPorts
import robotran.ui.pictures.DrawnWorldPictures
import robotran.ui.pictures.pictureFonts
import robotran.web.grading.WebGradingWorkers
import robotran.web.hub.WebHubPorts
import robotran.web.hub.WebMpyCompiler
import robotran.web.microbit.WebMicrobitPorts
import robotran.web.tower.WebTowers
import robotran.web.window.PageFonts
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.MemoryStore
import robotran.workshop.platform.NoOpeningMarks
import robotran.workshop.platform.NoWindowMemory
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpeningMarks
import robotran.workshop.platform.PhotoReader
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Posters
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.Sharing
import robotran.workshop.platform.VideoRecorder
import robotran.workshop.platform.WallClock
import robotran.workshop.platform.WebSite
import robotran.workshop.platform.WindowMemory
import robotran.workshop.sound.LoudSpeaker
import kotlin.io.encoding.Base64
import kotlin.js.Promise

/**
 * The services of a browser.
 *
 * @param embedded whether the page is embedded in another one; then it saves and restores nothing.
 */
internal class WebPlatform(
    override val speaker: LoudSpeaker,
    private val embedded: Boolean,
    private val fonts: PageFonts,
) : Platform {
    override val store: KeyValueStore = if (embedded) MemoryStore() else WebStore()
    override val files: FilePicker = WebFilePicker
    override val sharing: Sharing = WebSharing
    override val clock: WallClock = WebClock
    override val openRequests: OpenRequests = OpenRequests()
    override val window: WindowMemory = if (embedded) NoWindowMemory else WebWindowMemory
    override val openingMarks: OpeningMarks = if (embedded) NoOpeningMarks else WebOpeningMarks
    override val pageAddress: String = pageAddress()
    override val isForFingers: Boolean = isPointerCoarse()
    override var prefersLessMotion: Boolean by mutableStateOf(false)
        private set
    override val pictures: WorldPictures = DrawnWorldPictures { fonts.withEmoji ?: pictureFonts() }

    override val photoReader: PhotoReader = WebPhotoReader
    override val videos: VideoRecorder = WebVideoRecorder
    override val posters: Posters = WebPosters
    override val webSite: WebSite = OwnWebSite
    override val gradingWorkers: GradingWorkers = WebGradingWorkers
    override val qrScanner: QrScanner? = CameraQrScanner.find()

    // An embedded page sends nothing.
    override val towers: TowerPorts = if (embedded) NoTowerPorts else WebTowers()
    override val hubs: HubPorts by lazy(LazyThreadSafetyMode.NONE) { if (embedded) NoHubPorts else WebHubPorts() }
    override val microbits: MicrobitPorts by lazy(LazyThreadSafetyMode.NONE) {
        if (embedded) NoMicrobitPorts else WebMicrobitPorts()
    }
    override val mpyCompiler: MpyCompiler get() = WebMpyCompiler

    init {
        whenLessMotionChanges { prefersLessMotion = it }
        prepareReadingOfFiles()
        takeLink()
        onNewFragment(::takeLink)
        onFilesDropped { lines ->
            filesIn(lines).takeIf { it.isNotEmpty() }?.let { openRequests.bring(OpenRequest.OfFiles(it)) }
        }
    }

    /**
     * Opens the link in the page's URL and removes it there, so that a reload restores the edited project. An embedded
     * page keeps it, since it saves nothing.
     */
    private fun takeLink() {
        val fragment = takeFragment(stays = embedded)
        if (isLink(fragment)) openRequests.bring(OpenRequest.OfLink(fragment))
    }
}

private object WebSharing : Sharing {
    override val hasShareSheet: Boolean = canShare()

    override suspend fun copy(text: String): Boolean = copyText(text).await<JsBoolean>().toBoolean()

    override suspend fun share(text: String): Boolean = shareText(text).await<JsBoolean>().toBoolean()

    override val canShareFiles: Boolean = canSharePictures()

    override suspend fun shareFile(name: String, kind: FileKind, bytes: ByteArray): Boolean =
        shareFile(name, kind.mimeType, Base64.encode(bytes)).await<JsBoolean>().toBoolean()
}

private object WebClock : WallClock {
    override val now: Long get() = currentTime().toLong()

    override fun describe(milliseconds: Long, language: String): String =
        describeTime(milliseconds.toDouble(), language)

    override fun date(milliseconds: Long, language: String): String = describeDate(milliseconds.toDouble(), language)
}

private fun pageAddress(): String = js("location.href.split('#')[0]")

/** Whether the machine's main pointer is a finger: a phone or a tablet without a mouse. */
private fun isPointerCoarse(): Boolean = js("matchMedia('(pointer: coarse)').matches")

private fun whenLessMotionChanges(tell: (Boolean) -> Unit): Unit = js(
    """{
        const less = matchMedia('(prefers-reduced-motion: reduce)');
        less.addEventListener('change', () => tell(less.matches));
        tell(less.matches);
    }""",
)

/** The fragment of the URL. If it may be a link, removes it from the URL unless it [stays]. */
private fun takeFragment(stays: Boolean): String = js(
    """(() => {
        const fragment = location.hash;
        if (!stays && /^#[wphc]=/.test(fragment)) history.replaceState(history.state, '', location.href.split('#')[0]);
        return fragment;
    })()""",
)

private fun onNewFragment(take: () -> Unit): Unit = js("addEventListener('hashchange', () => take())")

private fun onFilesDropped(take: (String) -> Unit): Unit = js(
    """{
        addEventListener('dragover', (event) => event.preventDefault());
        addEventListener('drop', (event) => {
            event.preventDefault();
            if (event.dataTransfer) globalThis.robotranDropped(event.dataTransfer).then((lines) => take(lines));
        });
    }""",
)

/**
 * Calls [rest] when the page is hidden, after which the browser may discard it, and when the user leaves it: writes
 * started later might not complete.
 */
internal fun onOutOfSight(rest: () -> Unit): Unit = js(
    """{
            addEventListener('beforeunload', () => rest());
            document.addEventListener('visibilitychange', () => { if (document.visibilityState === 'hidden') rest(); });
            addEventListener('pagehide', () => rest());
        }""",
)

/** Makes the browser ask for confirmation before the user leaves the page while [wouldLose] returns true. */
internal fun askBeforeLosing(wouldLose: () -> Boolean): Unit =
    js("addEventListener('beforeunload', (event) => { if (wouldLose()) event.preventDefault(); })")

private fun canShare(): Boolean = js("typeof navigator.share === 'function'")

private fun copyText(text: String): Promise<JsBoolean> =
    js("(navigator.clipboard ? navigator.clipboard.writeText(text) : Promise.reject()).then(() => true, () => false)")

private fun shareText(text: String): Promise<JsBoolean> =
    js("navigator.share({ url: text }).then(() => true, () => false)")

private fun canSharePictures(): Boolean = js(
    """(() => {
        if (typeof navigator.canShare !== 'function') return false;
        try {
            return navigator.canShare({ files: [new File([new Uint8Array(1)], 'a.png', { type: 'image/png' })] });
        } catch (failure) {
            return false;
        }
    })()""",
)

/** Whoever closes the share sheet has not been refused. */
private fun shareFile(name: String, type: String, content: String): Promise<JsBoolean> = js(
    """(async () => {
        const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
        try {
            await navigator.share({ files: [new File([bytes], name, { type })] });
            return true;
        } catch (failure) {
            return failure.name === 'AbortError';
        }
    })()""",
)

private fun currentTime(): Double = js("Date.now()")

private fun describeTime(milliseconds: Double, language: String): String = js(
    """(() => {
        const time = new Date(milliseconds);
        const isToday = time.toDateString() === new Date().toDateString();
        const form = isToday ? { hour: 'numeric', minute: '2-digit' } : { day: 'numeric', month: 'short', year: 'numeric' };
        return time.toLocaleString(language || undefined, form);
    })()""",
)

private fun describeDate(milliseconds: Double, language: String): String =
    js("new Date(milliseconds).toLocaleDateString(language || undefined, { dateStyle: 'long' })")
